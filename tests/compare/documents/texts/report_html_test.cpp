// The page that is made of a result.
#include "compare/documents/texts/report_html.hpp"

#include <gtest/gtest.h>

#include "compare/documents/bytes/html.hpp"
#include "compare/documents/page/plot_json.hpp"
#include "tests/compare/results/complete_result.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

TEST(Html, EscapesMarkup) { EXPECT_EQ(html::escaped("<a href=\"x\">&"), "&lt;a href=&quot;x&quot;&gt;&amp;"); }

TEST(Html, GivesEachDrawingItsOwnIds) {
  const std::string svg = html::inline_svg(
      "<?xml?><svg><title>Gnuplot</title><g id=\"p\"/><use xlink:href='#p' fill='url(#q)' "
      "stroke='#0072B2'/></svg>",
      "f1-", "a < b");
  EXPECT_EQ(svg,
            "<svg><title>a &lt; b</title><g id=\"f1-p\"/><use xlink:href='#f1-p' fill='url(#f1-q)' "
            "stroke='#0072B2'/></svg>");
}

TEST(Html, WritesPicturesInBase64) {  // test vectors of RFC 4648
  for (const auto& [bytes, expected] : {std::pair{"", "base64,\""},
                                        {"f", "base64,Zg==\""},
                                        {"fo", "base64,Zm8=\""},
                                        {"foo", "base64,Zm9v\""},
                                        {"foob", "base64,Zm9vYg==\""},
                                        {"foobar", "base64,Zm9vYmFy\""}})
    EXPECT_NE(html::inline_png(bytes, "").find(expected), std::string::npos) << bytes;
}

TEST(Report, SaysWhatWasFound) {
  const TemporaryFolder folder;
  Result result = sample::full();  // whose like-for-like membrane has kept its sheet
  result.runs[3].continuum().pictures = std::make_shared<const std::vector<SheetPicture>>(1, sample::picture());
  write_report(result, folder.path(), folder / "report.html");
  EXPECT_EQ(folder.entries(), 1u) << "nothing but the page";
  const std::string page = folder.read("report.html");
  for (const char* words :
       {"<b>Agreement</b>", "atoms, disc", "membrane, point, paper constants", "sheet, disc, calibrated law",
        "What a plain membrane lacks", "Where continuum and atoms part", "What each model reads", "membrane itself",
        "How far to trust the fits", "17244 atoms", "SHA-256", "validate indentation --radius 110", "viewport",
        "@media print", "<svg", "data:image/png;base64,iVBOR"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  Result failing = result;
  failing.agreement->outcome = Outcome::disagree;
  EXPECT_NE(report_html(failing, {}).find("<b>Disagreement</b>"), std::string::npos);
}

/// How often a text is in another.
std::size_t count_of(const std::string& words, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + words.size())) ++count;
  return count;
}

TEST(Report, AsksForNothingFromOutside) {
  const TemporaryFolder folder;
  write_report(sample::full(), folder.path(), folder / "report.html");
  const std::string page = folder.read("report.html");
  for (const char* words : {"<link", "src=\"http", "src='", "@import", "url(http", "href=\"http", "href='http",
                            "<iframe", "fetch(", "import("})
    EXPECT_EQ(page.find(words), std::string::npos) << words;
  EXPECT_EQ(count_of("<script", page), 2u) << "the data and the page's own";
  EXPECT_NE(page.find("default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-"),
            std::string::npos);
}

TEST(Report, NamesAndCommandLinesAreTextNotMarkup) {
  const std::string hostile = "</script><script>alert(1)</script><!--<img src=x onerror=alert(1)>\xff";
  Result result = sample::full();
  result.provenance.command_line = result.resolved.potential = hostile;
  Plot plot{.title = hostile,
            .panels = {Panel{.title = hostile, .curves = {{.name = hostile, .x = {0, 1}, .y = {0, 1}}}}}};
  const std::string page =
      report_html(result, {{.title = hostile, .caption = hostile, .content = "<svg></svg>", .chart = plot_json(plot)}});
  EXPECT_EQ(count_of("<script", page), 2u);
  EXPECT_EQ(count_of("</script", page), 2u);
  EXPECT_EQ(count_of("<img src=x", page), 0u);
  EXPECT_EQ(count_of("<!--", page), 0u) << "it would hide the end of a script";
  EXPECT_NE(page.find("\\u003c/script>\\u003cscript>alert(1)"), std::string::npos) << "the data hold the name";
}

TEST(Report, FiguresThatAreNotDrawnAreDrawnByTheScript) {
  const std::string page = report_html(sample::full(), {{.title = "t", .caption = "c", .chart = "{}"}});
  EXPECT_NE(page.find("gnuplot is not installed"), std::string::npos);
  EXPECT_NE(page.find("<figure data-chart=\"0\">"), std::string::npos);
}

TEST(Report, IsMadeOfIncompleteResultsToo) {
  for (const Result& result : {sample::membrane_only(), sample::atoms_failed(), Result{}})
    EXPECT_NE(report_html(result, {}).find("No verdict"), std::string::npos);
}

}  // namespace

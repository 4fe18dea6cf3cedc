// run.h5 read back, and the page made of it.
#include "compare/documents/texts/report_html.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/base/errors.hpp"
#include "compare/documents/bytes/html.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/bytes/run_h5_read.hpp"
#include "compare/documents/texts/json.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

std::string document(const Result& result) { return summary_document(result).dump(1); }

TEST(RunH5Read, GivesBackEverythingThatTheSummaryHolds) {
  for (const Result& result : {sample::full(), sample::membrane_only(), sample::atoms_failed(), Result{}}) {
    const TemporaryFolder folder;
    write_run_h5(result, folder.path());
    EXPECT_EQ(document(read_run_h5(folder / "run.h5")), document(result));
  }
}

TEST(RunH5Read, KeepsTheDirectFitAndTheWarnings) {
  const TemporaryFolder folder;
  Result result = sample::full();
  result.runs[1].fit->direct = DirectFit{17.1, 0.1, 0.01, 0.002, 0.003};
  result.runs[1].fit->warnings = {"one", "two: κ"};
  write_run_h5(result, folder.path());
  const Result read = read_run_h5(folder / "run.h5");
  ASSERT_TRUE(read.runs[1].fit && read.runs[1].fit->direct);
  EXPECT_EQ(read.runs[1].fit->direct->pretension_stderr_eV_per_A2, 0.002);
  EXPECT_EQ(read.runs[1].fit->warnings, result.runs[1].fit->warnings);
  EXPECT_FALSE(read.runs[0].fit->direct);
}

TEST(RunH5Read, RefusesWhatIsNoRun) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::filesystem::path& file) -> std::string {
    try {
      read_run_h5(file);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(refusal(folder / "none.h5").find("there is no file"), std::string::npos);
  std::ofstream(folder / "text.h5") << "no HDF5";
  EXPECT_NE(refusal(folder / "text.h5").find("not an HDF5 file"), std::string::npos);
  write_run_h5(sample::full(), folder.path());
  std::ifstream in(folder / "run.h5", std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(in), {}};
  std::ofstream(folder / "cut.h5", std::ios::binary) << content.substr(0, content.size() / 2);
  EXPECT_NE(refusal(folder / "cut.h5"), "accepted");
}

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
  const Result result = sample::full();
  write_report(result, folder.path(), folder / "report.html");
  EXPECT_EQ(folder.entries(), 1u) << "nothing but the page";
  const std::string page = folder.read("report.html");
  for (const char* words :
       {"<b>Agreement</b>", "atoms, disc", "membrane, point, paper constants", "sheet, disc, calibrated law",
        "What a plain membrane lacks", "Where continuum and atoms part", "its bias", "How far to trust the fits",
        "17244 atoms", "SHA-256", "validate indentation --radius 110", "viewport", "@media print", "<svg",
        "data:image/png;base64,iVBOR"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  Result failing = result;
  failing.agreement->passed = false;
  EXPECT_NE(report_html(failing, {}).find("<b>Disagreement</b>"), std::string::npos);
}

TEST(Report, AsksForNothingFromOutside) {
  const TemporaryFolder folder;
  write_report(sample::full(), folder.path(), folder / "report.html");
  const std::string page = folder.read("report.html");
  for (const char* words :
       {"<script", "<link", "src=\"http", "src='", "@import", "url(http", "href=\"http", "href='http", "<iframe"})
    EXPECT_EQ(page.find(words), std::string::npos) << words;
}

TEST(Report, CommandLinesAreTextNotMarkup) {
  Result result = sample::membrane_only();
  result.provenance.command_line = "validate --out '<script>alert(1)</script>'";
  EXPECT_EQ(report_html(result, {}).find("<script"), std::string::npos);
}

TEST(Report, IsMadeOfIncompleteResultsToo) {
  for (const Result& result : {sample::membrane_only(), sample::atoms_failed(), Result{}})
    EXPECT_NE(report_html(result, {}).find("No verdict"), std::string::npos);
}

}  // namespace

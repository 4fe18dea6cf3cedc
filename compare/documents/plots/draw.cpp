#include "compare/documents/plots/draw.hpp"

#include <fmt/format.h>

#include <list>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"
#include "compare/documents/bytes/svg_compact.hpp"
#include "compare/documents/plots/gnuplot.hpp"
#include "compare/documents/plots/gnuplot_writer.hpp"
#include "compare/documents/plots/plot_csv.hpp"

namespace validate {
namespace {

// A picture without text or curves compresses to less.
constexpr std::uintmax_t smallest_png_bytes = 20000;

}  // namespace

std::optional<std::string> draw(const Plot& plot, const std::filesystem::path& folder, const std::string& name,
                                const std::vector<PictureFormat>& formats) {
  if (plot.panels.empty()) return std::nullopt;
  std::list<PendingFile> files;
  std::vector<Picture> pictures;
  std::string names;
  for (const PictureFormat format : formats) {
    const std::string file = name + extension(format);
    names += (names.empty() ? "" : " and ") + file;
    pictures.push_back({format, files.emplace_back(folder / file).path().filename()});  // whatever the folder's name
  }
  PendingFile script(folder / (name + ".gnuplot"));
  script.write(gnuplot_script(plot, pictures));
  const std::optional<GnuplotReport> report = run_gnuplot(script.path());
  if (!report) return "gnuplot is not installed: no " + names;
  const auto fail = [&](const std::string& what) {
    throw Error(ExitCode::file_failed, fmt::format("gnuplot {}: {}", what, report->messages));
  };
  if (!report->succeeded) fail("could not draw " + names);
  auto file = files.begin();
  for (const Picture& picture : pictures) {
    if (picture.format == PictureFormat::png && std::filesystem::file_size(file->path()) < smallest_png_bytes)
      fail("drew a " + name + ".png without text or curves");
    if (picture.format == PictureFormat::svg) file->write(compact_svg(read_file(file->path())));
    ++file;
  }
  for (PendingFile& drawn : files) drawn.commit();
  if (report->messages.empty()) return std::nullopt;
  return "gnuplot: " + report->messages;
}

std::optional<std::string> write_plot(const Plot& plot, const std::filesystem::path& folder, const std::string& name,
                                      const std::string& data_name) {
  if (plot.panels.empty()) return std::nullopt;
  write_file(folder / ((data_name.empty() ? name : data_name) + ".csv"), plot_csv(plot, "run.h5"));
  return draw(plot, folder, name);
}

}  // namespace validate

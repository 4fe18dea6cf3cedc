#include "compare/documents/plots/draw.hpp"

#include <fmt/core.h>

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

std::optional<std::string> draw(const Plot& plot, const std::filesystem::path& folder, const std::string& name) {
  if (plot.panels.empty()) return std::nullopt;
  PendingFile svg(folder / (name + ".svg")), png(folder / (name + ".png")), script(folder / (name + ".gnuplot"));
  script.write(gnuplot_script(plot, svg.path(), png.path()));
  const std::optional<GnuplotReport> report = run_gnuplot(script.path());
  if (!report) return fmt::format("gnuplot is not installed: no {0}.svg and {0}.png", name);
  if (!report->succeeded) {
    throw Error(ExitCode::file_failed,
                fmt::format("gnuplot could not draw {0}.svg and {0}.png: {1}", name, report->messages));
  }
  if (std::filesystem::file_size(png.path()) < smallest_png_bytes) {
    throw Error(ExitCode::file_failed,
                fmt::format("gnuplot drew a {}.png without text or curves: {}", name, report->messages));
  }
  svg.write(compact_svg(read_file(svg.path())));
  svg.commit();
  png.commit();
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

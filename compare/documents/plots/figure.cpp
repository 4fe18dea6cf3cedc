#include "compare/documents/plots/figure.hpp"

#include <fmt/core.h>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"
#include "compare/documents/bytes/svg_compact.hpp"
#include "compare/documents/plots/figure_commands.hpp"
#include "compare/documents/plots/gnuplot.hpp"
#include "compare/documents/plots/scan_commands.hpp"

namespace validate {

namespace {

std::string script_for(const std::string& commands, DrawingSize size, const PendingFile& svg, const PendingFile& png) {
  return fmt::format(
      "set encoding utf8\n"
      "set terminal svg size {0},{1} font 'DejaVu Sans,12' noenhanced background rgb 'white'\n"
      "set output {2}\n{6}\nunset output\nreset\nset encoding utf8\n"
      "set terminal pngcairo size {3},{4} font 'DejaVu Sans,12' fontscale 2 linewidth 2 pointscale 2 "
      "noenhanced\n"
      "set output {5}\n{6}\nunset output\n",
      size.width, size.height, gnuplot_quoted(svg.path().string()), 2 * size.width, 2 * size.height,
      gnuplot_quoted(png.path().string()), commands);
}

// A picture without text or curves compresses to less.
constexpr std::uintmax_t smallest_png_bytes = 20000;

}  // namespace

std::optional<std::string> draw(const std::string& commands, const std::filesystem::path& folder,
                                const std::string& name, DrawingSize size) {
  PendingFile svg(folder / (name + ".svg")), png(folder / (name + ".png")), script(folder / (name + ".gnuplot"));
  script.write(script_for(commands, size, svg, png));
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

std::optional<std::string> write_figure(const Result& result, const std::filesystem::path& folder) {
  return draw(figure_commands(result), folder, "figure");
}

std::optional<std::string> write_scan_figure(const Result& result, const std::filesystem::path& folder) {
  const std::string commands = scan_commands(result);
  if (commands.empty()) return std::nullopt;
  return draw(commands, folder, "window_scan", {900, 420});
}

}  // namespace validate

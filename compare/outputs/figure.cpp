#include "compare/outputs/figure.hpp"

#include <fmt/core.h>

#include "compare/errors.hpp"
#include "compare/outputs/figure_commands.hpp"
#include "compare/outputs/file.hpp"
#include "compare/outputs/gnuplot.hpp"

namespace compare {

namespace {

std::string script_for(const std::string& commands, const PendingFile& svg, const PendingFile& png) {
  return fmt::format(
      "set encoding utf8\n"
      "set terminal svg size 900,640 font 'DejaVu Sans,12' noenhanced background rgb 'white'\n"
      "set output {0}\n{2}unset output\n"
      "set terminal pngcairo size 1800,1280 font 'DejaVu Sans,12' fontscale 2 linewidth 2 pointscale 2 "
      "noenhanced\n"
      "set output {1}\nreplot\nunset output\n",
      gnuplot_quoted(svg.path().string()), gnuplot_quoted(png.path().string()), commands);
}

// A picture without text or curves compresses to less.
constexpr std::uintmax_t smallest_png_bytes = 20000;

}  // namespace

std::optional<std::string> write_figure(const Result& result, const std::filesystem::path& folder) {
  PendingFile svg(folder / "figure.svg"), png(folder / "figure.png"), script(folder / "figure.gnuplot");
  script.write(script_for(figure_commands(result), svg, png));
  const std::optional<GnuplotReport> report = run_gnuplot(script.path());
  if (!report) return "gnuplot is not installed: no figure.svg and figure.png (the data are in curves.csv)";
  if (!report->succeeded) {
    throw Error(ExitCode::file_failed,
                fmt::format("gnuplot could not draw figure.svg and figure.png: {}", report->messages));
  }
  if (std::filesystem::file_size(png.path()) < smallest_png_bytes) {
    throw Error(ExitCode::file_failed,
                fmt::format("gnuplot drew a figure.png without text or curves: {}", report->messages));
  }
  svg.commit();
  png.commit();
  if (report->messages.empty()) return std::nullopt;
  return "gnuplot: " + report->messages;
}

}  // namespace compare

#include "compare/documents/plots/explanation_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/documents/plots/gnuplot.hpp"

namespace validate {
namespace {

std::string line(const std::string& name, const std::vector<double>& values, const std::vector<std::size_t>& shown,
                 double factor, const char* format) {
  std::string text = fmt::format("  {:<34}", name);
  for (const std::size_t i : shown) {
    const double value = i < values.size() ? factor * values[i] : not_known;
    text += std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : fmt::format("{:>9}", "–");
  }
  return text + "\n";
}

/// The comparison's values at the depths of the explanation.
std::vector<double> at_depths(const std::vector<double>& values, const Comparison& c, const Explanation& e) {
  std::vector<double> picked;
  for (const double depth : e.depth_A) {
    const auto found = std::ranges::find(c.depth_A, depth);
    picked.push_back(found == c.depth_A.end() ? not_known
                                              : values[static_cast<std::size_t>(found - c.depth_A.begin())]);
  }
  return picked;
}

std::vector<double> whole(const Explanation& e) {
  std::vector<double> sums(e.depth_A.size(), 0);
  for (const Share& share : shares())
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (std::isfinite((e.*share.values)[i])) sums[i] += (e.*share.values)[i];
  return sums;
}

}  // namespace

const std::vector<Share>& shares() {
  static const std::vector<Share> all = {{"radii of clamp and tip", &Explanation::geometry, "#999999"},
                                         {"bending", &Explanation::bending, "#0072B2"},
                                         {"large-strain response", &Explanation::large_strain, "#D55E00"},
                                         {"anisotropy", &Explanation::anisotropy, "#CC79A7"},
                                         {"remainder", &Explanation::remainder, "#000000"}};
  return all;
}

std::vector<std::size_t> shown_depths(std::size_t count) {
  constexpr std::size_t most = 8;
  std::vector<std::size_t> shown;
  if (count <= most) {
    for (std::size_t i = 0; i < count; ++i) shown.push_back(i);
    return shown;
  }
  for (std::size_t k = 0; k < most; ++k) shown.push_back((k * (count - 1) + (most - 1) / 2) / (most - 1));
  return shown;
}

std::string explanation_text(const Result& result) {
  std::string text;
  for (const Explanation& e : result.explanations) {
    const auto c = std::ranges::find(result.comparisons, e.load, &Comparison::load);
    if (c == result.comparisons.end()) continue;
    const std::vector<std::size_t> shown = shown_depths(e.depth_A.size());
    text += fmt::format("{} load: what a plain membrane lacks, in % of its force, and what is left\n", e.load);
    text += line("depth / a", e.depth_relative, shown, 1, "{:9.3f}");
    for (const Share& share : shares()) text += line(share.name, e.*share.values, shown, 100, "{:+9.2f}");
    text += line("atoms over that membrane", whole(e), shown, 100, "{:+9.2f}");
    text += line("atoms / membrane, card constants", at_depths(c->force_ratio, *c, e), shown, 1, "{:9.4f}");
    text +=
        line("atoms / membrane, calibrated law", at_depths(c->calibrated_membrane_ratio, *c, e), shown, 1, "{:9.4f}");
    text += line("atoms / sheet, calibrated law", at_depths(c->sheet_ratio, *c, e), shown, 1, "{:9.4f}");
    text += "\n";
  }
  return text;
}

std::string explanation_commands(const Result& result) {
  std::string data, plots;
  const std::size_t panels = result.explanations.size();
  for (std::size_t p = 0; p < panels; ++p) {
    const Explanation& e = result.explanations[p];
    const std::vector<double> sums = whole(e);
    fmt::format_to(std::back_inserter(data), "$explained{} << EOD\n", p);
    for (const std::size_t i : shown_depths(e.depth_A.size())) {
      fmt::format_to(std::back_inserter(data), "{:.3f}", e.depth_relative[i]);
      for (const Share& share : shares()) {
        const double value = (e.*share.values)[i];
        fmt::format_to(std::back_inserter(data), " {}", std::isfinite(value) ? 100 * value : 0);
      }
      fmt::format_to(std::back_inserter(data), " {}\n", 100 * sums[i]);
    }
    data += "EOD\n";
    plots += fmt::format("set title {}\nplot ", gnuplot_quoted(e.load + " load"));
    for (std::size_t k = 0; k < shares().size(); ++k)
      plots += fmt::format("{}$explained{} using {}{} lc rgb '{}' title {}", k ? ", \\\n     " : "", p, k + 2,
                           k ? "" : ":xtic(1)", shares()[k].colour, gnuplot_quoted(shares()[k].name));
    plots += fmt::format(", \\\n     $explained{} using 0:{} with points pt 5 ps 0.9 lc rgb '#009E73' title 'atoms'\n",
                         p, shares().size() + 2);
  }
  if (panels == 0) return {};
  return data +
         fmt::format(
             "set multiplot layout 1,{}\nset style data histograms\nset style histogram rowstacked\n"
             "set style fill solid 0.85 noborder\nset boxwidth 0.7\nset xtics rotate by 45 right\n"
             "set xlabel 'depth / effective radius'\nset ylabel '% of the plain membrane force'\nset border 3 lw 1\n"
             "set tics nomirror out\nset grid y lc rgb '#e4e4e4' lw 1 lt 1\nset xzeroaxis lt 1 lc rgb 'black'\n"
             "set key inside top right samplen 1 font ',10'\n",
             panels) +
         plots + "unset multiplot\n";
}

}  // namespace validate

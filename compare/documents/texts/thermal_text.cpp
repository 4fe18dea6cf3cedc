#include "compare/documents/texts/thermal_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

std::string in_words(const Thermal& t) {
  return fmt::format("{} vibrations, {}", t.statistics,
                     t.rim == Rim::thermal ? fmt::format("the rim stretched by {:.3f} %", 100 * t.rim_strain)
                                           : "the rim where it is at T = 0");
}

/// Least and largest of what is known.
std::pair<double, double> range_of(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const double value : values)
    if (std::isfinite(value)) least = std::min(least, value), largest = std::max(largest, value);
  return {least, largest};
}

std::string sentence_of(const Run& run) {
  const Thermal& t = *run.thermal;
  const auto [least, largest] = range_of(t.force_ratio);
  if (!(least <= largest))
    return fmt::format("{} load at {:g} K: nothing is known ({})", run.load, t.temperature_K, t.unstable);
  std::string text =
      fmt::format("{} load at {:g} K ({}): the atoms' force at equal depth is {:.3f} to {:.3f} of that at T = 0",
                  run.load, t.temperature_K, in_words(t), least, largest);
  if (t.cold && t.warm)
    text +=
        fmt::format("; Eq. 16 reads E·h {:.1f} instead of {:.1f} N/m and a pretension of {:.2f} instead of {:.2f} N/m",
                    in_N_per_m(t.warm->Eh_eV_per_A2), in_N_per_m(t.cold->Eh_eV_per_A2),
                    in_N_per_m(t.warm->pretension_eV_per_A2), in_N_per_m(t.cold->pretension_eV_per_A2));
  return text + '.';
}

std::string line_of(const Run& run, std::size_t i) {
  const Thermal& t = *run.thermal;
  std::string line =
      fmt::format("{:9.3f}{:>12}{:>12}{:>13}", run.depth_A[i], number(t.depth_shift_A[i], "{:+.4f}"),
                  number(t.force_ratio[i], "{:.4f}"), number(t.lowest_eigenvalue_eV_per_A2[i], "{:.3g}"));
  if (!t.md || !(t.md->length_ps[i] > 0)) return line + '\n';
  return line + fmt::format("   {} ± {} in {:.0f} ps ({} samples, {} ps of warm-up)\n",
                            number(t.md->mean_A[i], "{:+.4f}"), number(t.md->error_A[i], "{:.4f}"), t.md->length_ps[i],
                            number(t.md->samples[i], "{:.0f}"), number(t.md->warm_up_ps[i], "{:.2f}"));
}

}  // namespace

std::vector<std::string> thermal_sentences(const Result& result) {
  std::vector<std::string> sentences;
  for (const Run& run : result.runs) {
    if (!run.thermal) continue;
    sentences.push_back(sentence_of(run));
    if (!run.thermal->unstable.empty())
      sentences.push_back(fmt::format("{} load: not stable {}: the quasi-harmonic sheet is none there.", run.load,
                                      run.thermal->unstable));
  }
  return sentences;
}

std::string thermal_table(const Result& result) {
  std::string text;
  for (const Run& run : result.runs) {
    if (!run.thermal) continue;
    const bool sampled = run.thermal->md.has_value();
    text += fmt::format("{} load at {:g} K\n  depth / Å  shift of it  force ratio  eV/Å² (least){}\n", run.load,
                        run.thermal->temperature_K, sampled ? "   shift by dynamics" : "");
    for (std::size_t i = 0; i < run.depth_A.size(); ++i) text += line_of(run, i);
    text += '\n';
  }
  return text;
}

std::string warm_lines(const std::vector<WarmSheet>& warm, double a0_A, double Eh_eV_per_A2) {
  if (warm.empty()) return {};
  std::string text = fmt::format("\nflat at {:g} K, flexural waves up to {:g} Å long; longer ones belong to the drum\n",
                                 warm.front().temperature_K, warm.front().longest_wave_A);
  for (const WarmSheet& w : warm) {
    if (!std::isfinite(w.lattice_constant_A)) {
      text += fmt::format("  {:10}no lattice constant: the flat sheet's vibrations are unstable\n",
                          to_string(w.statistics));
      continue;
    }
    if (!std::isfinite(w.Eh_eV_per_A2)) {
      text += fmt::format(
          "  {:10}a = {:.5f} Å ({:+.3f} %: the sheet {}); its vibrations have a kink under strain: no E·h\n",
          to_string(w.statistics), w.lattice_constant_A, 100 * (w.lattice_constant_A / a0_A - 1),
          w.stretch > 0 ? "expands" : "contracts");
      continue;
    }
    text += fmt::format("  {:10}a = {:.5f} Å ({:+.3f} %: the sheet {}), E·h = {:.1f} N/m ({:+.1f} %), nu = {:.4f}\n",
                        to_string(w.statistics), w.lattice_constant_A, 100 * (w.lattice_constant_A / a0_A - 1),
                        w.stretch > 0 ? "expands" : "contracts", in_N_per_m(w.Eh_eV_per_A2),
                        100 * (w.Eh_eV_per_A2 / Eh_eV_per_A2 - 1), w.nu);
  }
  return text;
}

}  // namespace validate

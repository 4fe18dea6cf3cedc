#include "compare/fitting/spread_mean.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace validate {
namespace {

struct Weighted {
  double mean = 0, weight = 0, squares = 0;
};

Weighted weighted(const std::vector<double>& x, const std::vector<double>& s, double tau2) {
  Weighted w;
  for (std::size_t i = 0; i < x.size(); ++i) w.weight += 1 / (s[i] * s[i] + tau2);
  for (std::size_t i = 0; i < x.size(); ++i) w.mean += x[i] / (s[i] * s[i] + tau2) / w.weight;
  for (std::size_t i = 0; i < x.size(); ++i) w.squares += std::pow(x[i] - w.mean, 2) / (s[i] * s[i] + tau2);
  return w;
}

struct Values {
  std::vector<double> Eh, Eh_error, pretension, pretension_error;

  void add(double modulus, double modulus_error, double tension, double tension_error) {
    if (!(modulus_error > 0) || !(tension_error > 0) || !std::isfinite(modulus_error + tension_error)) return;
    Eh.push_back(modulus);
    Eh_error.push_back(modulus_error);
    pretension.push_back(tension);
    pretension_error.push_back(tension_error);
  }
};

SpreadMean mean_of(const char* of, const Values& v) {
  SpreadMean m{.of = of, .count = static_cast<int>(v.Eh.size())};
  if (v.Eh.size() < 2) return m;
  const RandomEffects Eh = random_effects(v.Eh, v.Eh_error), N0 = random_effects(v.pretension, v.pretension_error);
  m.Eh_eV_per_A2 = Eh.mean;
  m.Eh_stderr_eV_per_A2 = Eh.standard_error;
  m.Eh_within_eV_per_A2 = Eh.within;
  m.Eh_between_eV_per_A2 = Eh.between;
  m.pretension_eV_per_A2 = N0.mean;
  m.pretension_within_eV_per_A2 = N0.within;
  m.pretension_between_eV_per_A2 = N0.between;
  return m;
}

}  // namespace

RandomEffects random_effects(const std::vector<double>& values, const std::vector<double>& errors) {
  const double wanted = static_cast<double>(values.size()) - 1;
  double low = 0, high = 0;
  if (weighted(values, errors, 0).squares > wanted) {
    const auto [least, most] = std::ranges::minmax(values);
    high = std::pow(most - least, 2);
    for (int i = 0; i < 200 && high - low > 1e-12 * high; ++i) {
      const double middle = (low + high) / 2;
      (weighted(values, errors, middle).squares > wanted ? low : high) = middle;
    }
  }
  const Weighted w = weighted(values, errors, high);
  double squares = 0;
  for (const double s : errors) squares += s * s / static_cast<double>(errors.size());
  return {w.mean, 1 / std::sqrt(w.weight), std::sqrt(squares), std::sqrt(high)};
}

std::vector<SpreadMean> spread_means(const std::vector<CurveRow>& rows) {
  Values curves, drums;
  std::map<std::string, Values> by_file;
  for (const CurveRow& row : rows) {
    if (!row.skipped.empty()) continue;
    const auto add_to = [&](Values& v) {
      v.add(row.Eh_eV_per_A2, row.Eh_noise_eV_per_A2, row.pretension_eV_per_A2, row.pretension_stderr_eV_per_A2);
    };
    add_to(curves);
    add_to(by_file[row.file]);
  }
  std::vector<SpreadMean> means = {mean_of("curves", curves)};
  if (by_file.size() < 2) return means;
  for (const auto& [file, v] : by_file) {
    if (v.Eh.empty()) continue;
    const RandomEffects Eh = random_effects(v.Eh, v.Eh_error), N0 = random_effects(v.pretension, v.pretension_error);
    drums.add(Eh.mean, Eh.standard_error, N0.mean, N0.standard_error);
  }
  means.push_back(mean_of("drums", drums));
  return means;
}

}  // namespace validate

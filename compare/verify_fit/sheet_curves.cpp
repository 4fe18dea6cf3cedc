#include "compare/verify_fit/sheet_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/base/units.hpp"
#include "sheet_curves_json.hpp"

namespace validate::verify {
namespace {

constexpr double A_per_nm = 10;

std::vector<double> divided(std::vector<double> values, double by) {
  for (double& value : values) value /= by;
  return values;
}

}  // namespace

KnownCurve::KnownCurve(MembraneTip tip, double Eh, double pretension, const std::vector<double>& depth,
                       const std::vector<double>& force)
    : tip_(std::move(tip)), Eh_(Eh), pretension_(pretension) {
  for (std::size_t i = 0; i < depth.size(); ++i) {
    log_depth_.push_back(std::log(depth[i]));
    ratio_.push_back(force[i] / depth[i]);
  }
}

double KnownCurve::force(double depth) const {
  constexpr std::ptrdiff_t around = 8;
  if (!(depth > 0)) return 0;
  const double x = std::max(std::log(depth), log_depth_.front());
  const auto size = static_cast<std::ptrdiff_t>(log_depth_.size());
  const auto after = std::ranges::upper_bound(log_depth_, x) - log_depth_.begin();
  const auto first = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - around / 2, 0, size - around));
  double sum = 0;
  for (std::size_t i = first; i < first + around; ++i) {
    double weight = 1;
    for (std::size_t k = first; k < first + around; ++k)
      if (k != i) weight *= (x - log_depth_[k]) / (log_depth_[i] - log_depth_[k]);
    sum += weight * ratio_[i];
  }
  return sum * depth;
}

std::string KnownCurve::name() const {
  return fmt::format("{} of {:g} nm, {:.2g} N/m", tip_.is_sphere() ? "sphere" : "disc", tip_.tip_A / A_per_nm,
                     pretension_ * N_per_m_per_eV_per_A2);
}

std::vector<KnownCurve> known_curves() {
  const auto all = nlohmann::json::parse(sheet_curves_json);
  std::vector<KnownCurve> curves;
  for (const auto& curve : all.at("curves")) {
    const MembraneTip tip{all.at("radius_nm").get<double>() * A_per_nm, all.at("nu").get<double>(),
                          curve.at("tip_radius_nm").get<double>() * A_per_nm, 0, curve.at("tip") == "sphere"};
    curves.emplace_back(tip, all.at("Eh_N_per_m").get<double>() / N_per_m_per_eV_per_A2,
                        curve.at("pretension_N_per_m").get<double>() / N_per_m_per_eV_per_A2,
                        divided(curve.at("depth_nm").get<std::vector<double>>(), 1 / A_per_nm),
                        divided(curve.at("force_nN").get<std::vector<double>>(), nN_per_eV_per_A));
  }
  return curves;
}

}  // namespace validate::verify

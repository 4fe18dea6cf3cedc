#include "compare/verify_fit/trials.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

#include "compare/base/units.hpp"
#include "compare/fitting/normal.hpp"

namespace validate::verify {
namespace {

constexpr double sigma_force = 5 / nN_per_eV_per_A, sigma_depth = 10;  // 5 nN, 1 nm
constexpr double contact = 30, force_zero = 5 / nN_per_eV_per_A;       // where the zeros are free
constexpr double first_depth = -200, last_depth = 980;                 // -20 to 98 nm of the file
constexpr double two_sided_95 = 1.959964;

/// A drum larger by a ratio, its tip with it, is the same sheet with depths and forces larger by it.
CurvePoints drawn(const KnownCurve& truth, const Experiment& experiment, Normal& normal) {
  const double larger = 1 + experiment.radius_error * normal(), stronger = 1 + experiment.force_error * normal();
  CurvePoints points;
  for (int i = 0; i < experiment.points; ++i) {
    const double file_depth = std::lerp(first_depth, last_depth, i / (experiment.points - 1.0));
    const double force = stronger * larger * truth.force((file_depth - contact) / larger);
    points.depth_A.push_back(file_depth + sigma_depth * normal() - (experiment.zeros_free ? 0 : contact));
    points.force_eV_per_A.push_back(force + sigma_force * normal() + (experiment.zeros_free ? force_zero : 0));
  }
  points.noise.force_eV_per_A = experiment.noise_known ? std::optional(sigma_force) : std::nullopt;
  points.noise.depth_A = experiment.noise_known ? std::optional(sigma_depth) : std::nullopt;
  return points;
}

void count(Tally& tally, double value, const std::array<double, 2>& interval, double truth) {
  tally.covered += interval[0] <= truth && truth <= interval[1];
  tally.error += value - truth;
  tally.square += std::pow(value - truth, 2);
  const double width = interval[1] - interval[0];
  if (std::isfinite(width)) {
    ++tally.finite;
    tally.stated += width / (2 * two_sided_95);
  }
}

/// The least (or most) share of n that a binomial variable of this probability is, but for one in 2000.
double binomial_limit(double probability, int n, bool least) {
  constexpr double beyond = 5e-4;
  const auto count = static_cast<unsigned>(n);
  unsigned k = least ? 0 : count;
  if (least)
    while (gsl_cdf_binomial_P(k, probability, count) < beyond) ++k;
  else
    while (k > 0 && gsl_cdf_binomial_Q(k - 1, probability, count) < beyond) --k;
  return static_cast<double>(k) / n;
}

void add_parameter(Ledger& ledger, const std::string& name, const Tally& tally, int n, double truth) {
  constexpr double of_stated = 0.2, of_value = 1e-3, chance = 3.3, most_open = 0.02;
  constexpr double least = 0.93, most = 0.97, nominal = 0.95;
  constexpr int enough = 1000;
  const double stated = tally.stated / tally.finite, bias = tally.error / n,
               scatter = std::sqrt(tally.square / n - bias * bias);
  const bool few = n < enough;
  const double by_chance = few ? chance * scatter / stated / std::sqrt(n) : 0;
  const auto N_per_m = [](double value) { return value * N_per_m_per_eV_per_A2; };
  const std::string note = fmt::format("bias {:.3g}, scatter {:.3g}, stated {:.3g} N/m of {:.3g}; {} curves",
                                       N_per_m(bias), N_per_m(scatter), N_per_m(stated), N_per_m(truth), n);
  ledger.at_most(name + ": bias / stated error", std::abs(bias) / stated,
                 {of_stated + of_value * truth / stated + by_chance,
                  fmt::format("0.2 + 0.1 % of the value{}", few ? " + what chance makes of so few curves" : "")},
                 note);
  ledger.at_most(name + ": intervals without an end", 1 - static_cast<double>(tally.finite) / n,
                 {most_open, "2 %, where the noise is sought"}, note);
  const double covered = static_cast<double>(tally.covered) / n;
  const std::string origin = few ? "binomial, 95 %, but for one in 2000" : "95 % within 2 %";
  ledger.at_least(name + ": share that the interval holds", covered,
                  {few ? binomial_limit(nominal, n, true) : least, origin}, note);
  ledger.at_most(name + ": share that the interval holds", covered,
                 {few ? binomial_limit(nominal, n, false) : most, origin}, note);
}

}  // namespace

namespace {

/// What is kept of a fit.
struct Reading {
  double value = 0;
  std::array<double, 2> interval{};
};
struct Readings {
  Reading Eh, pretension;
};

std::optional<Readings> read(const CurvePoints& points, const ForceModel& table, const InferenceOptions& options) {
  const auto found = infer(points, table, options);
  const Fit* fit = std::get_if<Fit>(&found);
  if (!fit) return std::nullopt;
  return Readings{{fit->Eh_eV_per_A2, fit->Eh_interval_eV_per_A2},
                  {fit->pretension_eV_per_A2, fit->pretension_interval_eV_per_A2}};
}

/// In the order of the curves, on all cores.
std::vector<std::optional<Readings>> read_all(const std::vector<CurvePoints>& curves, const ForceModel& table,
                                              const InferenceOptions& options) {
  std::vector<std::optional<Readings>> all(curves.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < curves.size(); i = next++) all[i] = read(curves[i], table, options);
  };
  std::vector<std::jthread> others;
  for (unsigned core = 1; core < std::thread::hardware_concurrency(); ++core) others.emplace_back(work);
  work();
  others.clear();  // joins them
  return all;
}

}  // namespace

Trials try_fits(const KnownCurve& truth, const ForceModel& table, const std::vector<UncertainInput>& inputs,
                const Experiment& experiment, int curves, std::uint32_t seed) {
  InferenceOptions options;
  options.free = {experiment.zeros_free, experiment.zeros_free, false};
  options.inputs = inputs;
  Normal normal(seed);
  std::vector<CurvePoints> points;
  for (int i = 0; i < curves; ++i) points.push_back(drawn(truth, experiment, normal));
  Trials trials;
  trials.curves = curves;
  for (const auto& reading : read_all(points, table, options)) {
    if (!reading) continue;
    ++trials.fitted;
    count(trials.Eh, reading->Eh.value, reading->Eh.interval, truth.Eh_eV_per_A2());
    count(trials.pretension, reading->pretension.value, reading->pretension.interval, truth.pretension_eV_per_A2());
  }
  return trials;
}

void add_rows(Ledger& ledger, const KnownCurve& truth, const Trials& trials) {
  ledger.begin(truth.name());
  ledger.equal("curves that are fitted", trials.fitted, {static_cast<double>(trials.curves), "all"}, 0);
  add_parameter(ledger, "E·h", trials.Eh, trials.fitted, truth.Eh_eV_per_A2());
  add_parameter(ledger, "pretension", trials.pretension, trials.fitted, truth.pretension_eV_per_A2());
}

}  // namespace validate::verify

#include "compare/instruments/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"
#include "compare/instruments/baseline.hpp"

namespace validate {
namespace {

constexpr double nm_per_A = 0.1;

double middle_of(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, at);
  return *at;
}

/// These elements, in this order.
std::vector<double> taken(const std::vector<double>& values, const std::vector<std::size_t>& which) {
  std::vector<double> some;
  for (const std::size_t i : which) some.push_back(values.at(i));
  return some;
}

void keep(MeasuredCurve& curve, const std::vector<std::size_t>& which) {
  for (auto* column : {&curve.depth_A, &curve.force_eV_per_A, &curve.sigma_eV_per_A, &curve.sigma_depth_A})
    if (!column->empty()) *column = taken(*column, which);
}

std::vector<std::size_t> order_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  return order;
}

void turn(std::vector<double>& values) {
  for (double& value : values) value = -value;
}

/// The end that is far from the level of most points is in the sheet, and the tip is pushed back there.
void orient(MeasuredCurve& curve, CurvePreparation& done) {
  const std::vector<double> forces = taken(curve.force_eV_per_A, order_of(curve.depth_A));
  const std::size_t few = std::max<std::size_t>(forces.size() / 20, 1);
  const auto mean = [&](auto from, auto to) { return std::accumulate(from, to, 0.0) / static_cast<double>(few); };
  const auto count = static_cast<std::ptrdiff_t>(few);
  const double level = middle_of(forces), first = mean(forces.begin(), forces.begin() + count) - level,
               last = mean(forces.end() - count, forces.end()) - level;
  done.height_turned = std::abs(first) > std::abs(last);
  done.force_turned = (done.height_turned ? first : last) < 0;
  if (done.height_turned) turn(curve.depth_A);
  if (!done.force_turned) return;
  turn(curve.force_eV_per_A);
  curve.notes.push_back("the force falls where the tip presses: its sign is turned");
}

/// The way back has its own level; between the line's noise and its return to it the tip is held.
std::optional<PullOff> pull_off(const WayBack& back, const CurvePreparation& done, double stiffness) {
  WayBack way = back;
  if (done.height_turned) turn(way.height_A);
  if (done.force_turned) turn(way.force_eV_per_A);
  const std::vector<std::size_t> order = order_of(way.height_A);
  const std::vector<double> z = taken(way.height_A, order), force = taken(way.force_eV_per_A, order);
  constexpr std::size_t fewest = 20;
  if (z.size() < fewest) return std::nullopt;
  const StraightLine far = robust_line(z, force, 0, z.size() / 4, false);
  const auto f = [&](std::size_t i) { return force[i] - far.level - done.tilt_eV_per_A2 * (z[i] - far.origin); };
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < z.size(); ++i)
    if (f(i) < f(lowest)) lowest = i;
  if (!(-f(lowest) > 5 * std::max(far.spread, done.noise_eV_per_A))) return std::nullopt;
  PullOff pull{-f(lowest), 0};
  const auto tip = [&](std::size_t i) { return std::isfinite(stiffness) ? z[i] - f(i) / stiffness : z[i]; };
  const auto area = [&](std::size_t i) {
    return -(std::min(f(i), 0.0) + std::min(f(i + 1), 0.0)) / 2 * (tip(i + 1) - tip(i));
  };
  for (std::size_t i = lowest; i + 1 < z.size() && f(i) < 0; ++i) pull.work_eV += area(i);
  for (std::size_t i = lowest; i > 0 && f(i) < -2 * far.spread; --i) pull.work_eV += area(i - 1);
  return pull;
}

/// The line goes off, the zero of the heights to the contact; what was in between is left out.
void take_off(MeasuredCurve& curve, CurvePreparation& done, const BeforeContact& before, Baseline baseline) {
  const bool has_line = before.line.points > 0;
  done.contact_A = curve.depth_A[before.contact];
  if (has_line && baseline != Baseline::none) {
    done.baseline = baseline;
    done.level_eV_per_A = before.line.at(done.contact_A);
    done.tilt_eV_per_A2 = before.line.tilt;
  }
  done.noise_eV_per_A = before.line.spread;
  done.baseline_points = before.line.points;
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i) {
    const double depth = curve.depth_A[i] - done.contact_A;
    curve.force_eV_per_A[i] -= done.level_eV_per_A + done.tilt_eV_per_A2 * depth;
    curve.depth_A[i] = depth;
  }
  if (!has_line || before.snap >= before.contact) return;
  done.snap_in = SnapIn{before.attraction, static_cast<int>(before.contact - before.snap)};
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i)
    if (i < before.snap || i >= before.contact) kept.push_back(i);
  keep(curve, kept);
}

/// Of very many points neighbours are averaged: that loses nothing that the sheet's curve has, and a fit takes as long
/// as it has points.
void average(MeasuredCurve& curve) {
  constexpr std::size_t most = 2000, wanted = 1000;
  const std::size_t n = curve.depth_A.size();
  if (n <= most) return;
  const std::size_t block = (n + wanted - 1) / wanted;
  const double independent = 1 / std::sqrt(static_cast<double>(block));
  const auto means = [&](const std::vector<double>& values, double factor) {
    std::vector<double> some;
    for (std::size_t from = 0; from + block <= n; from += block)
      some.push_back(factor *
                     std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(from),
                                     values.begin() + static_cast<std::ptrdiff_t>(from + block), 0.0) /
                     static_cast<double>(block));
    return some;
  };
  for (auto* column : {&curve.depth_A, &curve.force_eV_per_A}) *column = means(*column, 1);
  for (auto* sigma : {&curve.sigma_eV_per_A, &curve.sigma_depth_A})
    if (!sigma->empty()) *sigma = means(*sigma, independent);
  curve.notes.push_back(fmt::format("{} points are averaged by {}", n, block));
}

void add_notes(MeasuredCurve& curve, const CurvePreparation& done) {
  const auto note = [&](std::string text) { curve.notes.push_back(std::move(text)); };
  note(fmt::format("heights begin at the first estimate of the contact, {:.6g} nm", nm_per_A * done.contact_A));
  if (done.baseline == Baseline::none)
    note("no baseline is taken off");
  else
    note(fmt::format("taken off: {:.4g} nN{}, the line through {} points before the contact (noise {:.3g} nN)",
                     nN_per_eV_per_A * done.level_eV_per_A,
                     done.baseline == Baseline::tilt
                         ? fmt::format(" and {:.3g} nN/nm", N_per_m_per_eV_per_A2 * done.tilt_eV_per_A2)
                         : "",
                     done.baseline_points, nN_per_eV_per_A * done.noise_eV_per_A));
  if (done.snap_in)
    note(fmt::format("snap-in of {:.3g} nN: {} points before the contact are left out",
                     nN_per_eV_per_A * done.snap_in->force_eV_per_A, done.snap_in->points));
  if (done.pull_off)
    note(fmt::format("pull-off force on the way back {:.4g} nN, work {:.4g} eV",
                     nN_per_eV_per_A * done.pull_off->force_eV_per_A, done.pull_off->work_eV));
}

}  // namespace

void prepare(MeasuredCurve& curve, Baseline baseline, const WayBack& back) {
  if (curve.depth_A.size() < 2) return;
  CurvePreparation done;
  orient(curve, done);
  keep(curve, order_of(curve.depth_A));
  done.raw_height_A = curve.depth_A;
  done.raw_force_eV_per_A = curve.force_eV_per_A;
  const BeforeContact before = before_contact(curve.depth_A, curve.force_eV_per_A, baseline == Baseline::tilt);
  const double risen = curve.force_eV_per_A.back() - before.line.at(curve.depth_A.back());
  constexpr double clear = 10;  // standard deviations
  if (before.line.points > 0 && !(risen > clear * before.line.spread))
    throw bad_input("{}: no contact: at its end the force is {:.3g} nN above the baseline, whose noise is {:.3g} nN",
                    curve.file.string(), nN_per_eV_per_A * risen, nN_per_eV_per_A * before.line.spread);
  take_off(curve, done, before, baseline);
  done.pull_off = pull_off(back, done, curve.spring_constant_eV_per_A2.value_or(NAN));
  add_notes(curve, done);
  average(curve);
  curve.preparation = std::move(done);
}

}  // namespace validate

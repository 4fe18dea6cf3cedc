#include "compare/fitting/sheet_table.hpp"

#include <fmt/format.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "compare/fitting/even_spline.hpp"
#include "compare/fitting/sheet_ratio.hpp"

namespace validate {
namespace {

constexpr int knots = 129;  ///< of the splines over ln d: where a law ends the ratio bends within a tenth of the depth
constexpr double shallowest_share = 0.02;
constexpr int most_pretensions = 9;
constexpr double least_share = 1e-4;
constexpr double Eh_share = 0.15;  ///< the table reaches from (1 − this) to 1/(1 − this) of E·h

/// Depths and pretensions that are solved. The shallow sphere's form is no solution between its limits: its ratio asks
/// for more.
struct Nodes {
  int depths, pretensions;
};
Nodes nodes_of(const MembraneTip& tip, bool coarse) {
  if (coarse) return {12, 4};
  return tip.is_sphere() ? Nodes{20, 9} : tip.bending_eV() > 0 ? Nodes{tip.physics->scales ? 16 : 24, 5} : Nodes{16, 4};
}

struct FreeSpline {
  void operator()(gsl_interp* p) const { gsl_interp_free(p); }
};

/// y over x at other x inside, by a cubic spline without curvature at its ends.
std::vector<double> resampled(const std::vector<double>& x, const std::vector<double>& y,
                              const std::vector<double>& at) {
  const std::unique_ptr<gsl_interp, FreeSpline> spline(gsl_interp_alloc(gsl_interp_cspline, x.size()));
  gsl_interp_init(spline.get(), x.data(), y.data(), x.size());
  std::vector<double> values;
  for (const double t : at)
    values.push_back(gsl_interp_eval(spline.get(), x.data(), y.data(), std::clamp(t, x.front(), x.back()), nullptr));
  return values;
}

/// Chebyshev's points of the second kind on [low, high] and the polynomial through values there.
class Chebyshev {
 public:
  Chebyshev(double low, double high, int count) {
    for (int i = 0; i < count; ++i) {
      const double t = count == 1 ? 0 : -std::cos(std::numbers::pi * i / (count - 1));
      at_.push_back((low + high) / 2 + (high - low) / 2 * t);
    }
  }
  const std::vector<double>& points() const { return at_; }

  /// Lagrange's weights of the points at x, and their derivatives.
  void weights(double x, double* value, double* slope) const {
    const auto n = at_.size();
    for (std::size_t j = 0; j < n; ++j) {
      double product = 1, derivative = 0;
      for (std::size_t k = 0; k < n; ++k) {
        if (k == j) continue;
        const double span = at_[j] - at_[k];
        derivative = derivative * (x - at_[k]) / span + product / span;
        product *= (x - at_[k]) / span;
      }
      value[j] = product;
      slope[j] = derivative;
    }
  }

 private:
  std::vector<double> at_;
};

class Table {
 public:
  Table(const MembraneTip& tip, const TableRange& range)
      : tip_(tip),
        shallow_(tip, range.deepest_A),
        Eh_(range.Eh_eV_per_A2),
        scale_(0.05 * std::pow(range.deepest_A / tip.a_A, 2)),
        levels_{0.5 * shallowest_share * range.deepest_A, 1.2 * range.deepest_A},
        nodes_(nodes_of(tip, range.coarse)),
        over_pretension_(0, std::log1p(std::max(range.pretension_share, least_share) / scale_), nodes_.pretensions),
        over_Eh_(1 - Eh_share, 1 / (1 - Eh_share), Eh_nodes()) {
    solve(range.deepest_A);
    if (!range.coarse) measure_error();
  }

  double deepest() const { return std::exp(steps_.first + (knots - 1) * steps_.step); }
  double error() const { return error_; }

  ForceAt at(double depth, double Eh, double pretension) const {
    const double log_depth = std::log(depth);
    const EvenPlace place = steps_.place(log_depth);
    const bool inside = log_depth >= steps_.first && log_depth <= std::log(deepest());
    RatioAt ratio;
    for (const auto& [spline, share] : shares(Eh, pretension)) {
      const double value = inside ? spline->at(place) : over_depth(*spline, place, log_depth, depth).value;
      ratio.value += share.value * value;
      ratio.by_Eh += share.by_Eh * value;
      ratio.by_pretension += share.by_pretension * value;
    }
    const ForceAt flat = shallow_.along(depth, Eh, pretension).value;
    return {ratio.value * flat.force, ratio.value * flat.by_Eh + ratio.by_Eh * flat.force,
            ratio.value * flat.by_pretension + ratio.by_pretension * flat.force};
  }

  /// One sheet: its ratio over the depth is a spline too.
  ForceCurve curve(double Eh, double pretension) const {
    EvenSpline value, by_Eh, by_pretension;
    for (const auto& [spline, share] : shares(Eh, pretension)) {
      value.add(share.value, *spline);
      by_Eh.add(share.by_Eh, *spline);
      by_pretension.add(share.by_pretension, *spline);
    }
    return [this, Eh, pretension, value = std::move(value), by_Eh = std::move(by_Eh),
            by_pretension = std::move(by_pretension)](double depth) {
      const double log_depth = std::log(depth);
      const EvenPlace place = steps_.place(log_depth);
      const SplineAlong r = over_depth(value, place, log_depth, depth),
                        by_e = over_depth(by_Eh, place, log_depth, depth),
                        by_s = over_depth(by_pretension, place, log_depth, depth);
      const ForceAlong s = shallow_.along(depth, Eh, pretension);
      const auto product = [&](double flat, const SplineAlong& by) {
        return r.value * flat + by.value * s.value.force;
      };
      const auto slope = [&](double flat, double flat_slope, const SplineAlong& by) {
        return r.first * flat + r.value * flat_slope + by.first * s.value.force + by.value * s.first.force;
      };
      return ForceAlong{{r.value * s.value.force, product(s.value.by_Eh, by_e), product(s.value.by_pretension, by_s)},
                        {r.first * s.value.force + r.value * s.first.force, slope(s.value.by_Eh, s.first.by_Eh, by_e),
                         slope(s.value.by_pretension, s.first.by_pretension, by_s)},
                        r.second * s.value.force + 2 * r.first * s.first.force + r.value * s.second};
    };
  }

 private:
  struct RatioAt {
    double value = 0, by_Eh = 0, by_pretension = 0;
  };

  /// From ln d to d. A spline goes on without a kink: deeper as a straight line, and to a constant where there is no
  /// depth.
  SplineAlong over_depth(const EvenSpline& spline, const EvenPlace& place, double log_depth, double depth) const {
    constexpr double fading = 0.5;
    SplineAlong s = spline.along(place);
    const double before = log_depth - steps_.first, after = before - (knots - 1) * steps_.step;
    if (before < 0) {
      const double left = std::exp(before / fading);
      s = {s.value - s.first * fading * (1 - left), s.first * left, s.first * left / fading};
    } else if (after > 0) {
      s = {s.value + s.first * after, s.first, 0};
    }
    return {s.value, s.first / depth, (s.second - s.first) / (depth * depth)};
  }

  /// What each spline counts for in the ratio and its derivatives.
  std::vector<std::pair<const EvenSpline*, RatioAt>> shares(double Eh, double pretension) const {
    double over_s[most_pretensions], by_s[most_pretensions], over_u[3], by_u[3];
    const double s = pretension / Eh;
    // Beyond the table the ratio stays what it is at its end: enough for a first guess.
    const double asked = Eh_ / Eh, u = std::clamp(asked, over_Eh_.points().front(), over_Eh_.points().back());
    const double most = over_pretension_.points().back(), wanted = s >= 0 ? std::log1p(s / scale_) : s / scale_;
    const double v = std::clamp(wanted, -most, most);
    const double v_by_s = v != wanted ? 0 : s >= 0 ? 1 / (scale_ + s) : 1 / scale_;
    over_pretension_.weights(std::max(v, 0.0), over_s, by_s);
    // Without tension the ratio goes on as a straight line: the polynomial would leave it soon.
    for (std::size_t i = 0; i < over_pretension_.points().size(); ++i) over_s[i] += std::min(v, 0.0) * by_s[i];
    over_Eh_.weights(u, over_u, by_u);
    std::vector<std::pair<const EvenSpline*, RatioAt>> all;
    const auto nodes_u = over_Eh_.points().size(), nodes_s = over_pretension_.points().size();
    for (std::size_t j = 0; j < nodes_u; ++j)
      for (std::size_t i = 0; i < nodes_s; ++i) {
        const double by_share = over_u[j] * by_s[i] * v_by_s, by_ratio = u == asked ? by_u[j] * over_s[i] : 0;
        all.emplace_back(&splines_[j * nodes_s + i],
                         RatioAt{over_u[j] * over_s[i], -(by_share * s + by_ratio * u) / Eh, by_share / Eh});
      }
    return all;
  }

  /// Bending's share is nearly in proportion to 1/E·h; a law that does not scale asks for one more.
  int Eh_nodes() const { return exact_in_Eh() ? 1 : !tip_.physics || tip_.physics->scales ? 2 : 3; }

  bool exact_in_Eh() const { return !(tip_.bending_eV() > 0) && (!tip_.physics || tip_.physics->scales); }

  void solve(double deepest) {
    const auto &u = over_Eh_.points(), &v = over_pretension_.points();
    std::vector<RatioCurve> curves(u.size() * v.size());
    double end = std::log(deepest);
    // The tightest sheet ends first: the search for its end is not made again for the others.
    for (std::size_t i = v.size(); i-- > 0;)
      for (std::size_t j = 0; j < u.size(); ++j) {
        const double Eh = Eh_ / u[j];
        RatioCurve& curve = curves[j * v.size() + i];
        curve = solved_ratio(tip_, shallow_, Eh, Eh * scale_ * std::expm1(v[i]), levels_, nodes_.depths);
        end = std::min(end, curve.log_depth.back());
        const bool ended = curve.last_level < levels_.high * (1 - 1e-9);
        levels_.law_ends = levels_.law_ends || ended;
        if (ended) levels_.high = curve.last_level;
      }
    const double start = std::log(shallowest_share * deepest);
    steps_ = {start, (end - start) / (knots - 1), knots};
    std::vector<double> log_depth;
    for (int i = 0; i < knots; ++i) log_depth.push_back(start + i * steps_.step);
    for (const RatioCurve& curve : curves)
      splines_.emplace_back(steps_, resampled(curve.log_depth, curve.ratio, log_depth));
  }

  /// Against a sheet halfway between two pretensions of the table, where polynomials are worst, and halfway between its
  /// depths.
  void measure_error() {
    const auto& v = over_pretension_.points();
    const double between = (v[1] + v[2]) / 2, Eh = Eh_ / (exact_in_Eh() ? 1 : 1 - Eh_share / 2);
    const double pretension = Eh * scale_ * std::expm1(between);
    const RatioCurve curve = solved_ratio(tip_, shallow_, Eh, pretension, levels_, nodes_.depths, -0.5);
    const double deepest_force = at(this->deepest(), Eh, pretension).force;
    for (std::size_t i = 0; i < curve.ratio.size(); ++i) {
      const double d = std::exp(curve.log_depth[i]);
      if (d > this->deepest()) break;
      const double miss = std::abs(curve.ratio[i] * shallow_.force(d, Eh, pretension) - at(d, Eh, pretension).force);
      error_ = std::max(error_, miss / deepest_force);
    }
    // One sheet does not meet the worst place; and those of the table have fewer elements than a membrane that is
    // solved.
    constexpr double safety = 3, mesh = 2e-5;
    error_ = safety * error_ + mesh;
  }

  MembraneTip tip_;
  ShallowSheet shallow_;
  double Eh_, scale_;
  Levels levels_;  ///< from half the shallowest to beyond the deepest: a spline is worst at its ends
  Nodes nodes_;
  Chebyshev over_pretension_, over_Eh_;
  EvenSteps steps_;                  ///< of ln d
  std::vector<EvenSpline> splines_;  ///< one per E·h and pretension of the table
  double error_ = 0;
};

/// To the next power of this base.
double rounded_up(double value, double base) { return std::pow(base, std::ceil(std::log(value) / std::log(base))); }

/// One of the paper's membrane, which scales with E·h, serves all curves of a drum: its range is rounded up, and it is
/// kept. For any number of threads; two that ask at once may both make it.
std::shared_ptr<const Table> table_of(const MembraneTip& tip, const TableRange& range) {
  if (tip.physics) return std::make_shared<const Table>(tip, range);
  constexpr double any_Eh = 20, depths = 1.1, shares = 1.5;
  const TableRange round{rounded_up(range.deepest_A, depths), any_Eh,
                         rounded_up(std::max(range.pretension_share, least_share), shares), range.coarse};
  using Key = std::array<double, 8>;
  static std::mutex mutex;
  static std::map<Key, std::shared_ptr<const Table>> known;
  const Key key{tip.a_A,
                tip.nu,
                tip.tip_A,
                tip.record_radius_A,
                tip.is_sphere() ? 1.0 : 0.0,
                round.deepest_A,
                round.pretension_share,
                round.coarse ? 1.0 : 0.0};
  {
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  auto table = std::make_shared<const Table>(tip, round);
  const std::lock_guard lock(mutex);
  return known.try_emplace(key, std::move(table)).first->second;
}

}  // namespace

ForceModel sheet_table(const MembraneTip& tip, const TableRange& range) {
  const auto table = table_of(tip, range);
  return {[table](double depth, double Eh, double pretension) { return table->at(depth, Eh, pretension); },
          table->deepest(), table->error(), range.Eh_eV_per_A2,
          [table](double Eh, double pretension) -> ForceCurve {
            return [table, curve = table->curve(Eh, pretension)](double depth) { return curve(depth); };
          }};
}

std::vector<double> membrane_forces(const MembraneTip& tip, double Eh, double pretension,
                                    const std::vector<double>& depth) {
  const double deepest = std::ranges::max(depth);
  const ForceModel table = sheet_table(tip, {deepest, Eh, std::max(pretension / Eh, 0.0)});
  if (table.deepest_A < deepest * (1 - 1e-9))
    throw std::runtime_error(fmt::format("the membrane did not converge beyond {:g} Å", table.deepest_A));
  std::vector<double> force;
  for (const double d : depth) force.push_back(table.at(d, Eh, pretension).force);
  return force;
}

ForceModel with_tip(const ForceModel& table, const MembraneTip& tip, const MembraneTip& other, TableRange range) {
  range.coarse = true;
  const ForceModel here = sheet_table(tip, range), there = sheet_table(other, range);
  return sum_of({{1, table}, {1, there}, {-1, here}});
}

}  // namespace validate

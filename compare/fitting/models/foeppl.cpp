#include "compare/fitting/models/foeppl.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace validate {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using std::numbers::pi;

/// Points t_i = −T (1 − i/n)²: close together at the rim, where bending has its boundary layer; one of them
/// is the edge of the loaded disc.
struct Grid {
  int n;
  double span;  // T
  explicit Grid(double tip, int intervals) : n(intervals), span(14) {
    if (!(tip > 0 && tip < 1)) return;
    const double edge = -std::log(tip);
    const int coarse = coarsest(n);
    const double m = std::max(1.0, std::round(coarse * std::sqrt(edge / (edge + 6))));
    span = edge * (coarse / m) * (coarse / m);
  }
  // Grids that are refined by doubling keep the same span.
  static int coarsest(int n) {
    while (n % 2 == 0 && n > 100) n /= 2;
    return n;
  }
  double t(double i) const { return -span * (1 - i / n) * (1 - i / n); }
  double dt(double i) const { return 2 * span * (1 - i / n) / n; }  // dt/di
  double x(double i) const { return std::exp(t(i)); }
};

double enclosed(const FoepplDisc& disc, double force, double x) {
  return disc.tip > 0 && x < disc.tip ? force * (x / disc.tip) * (x / disc.tip) : force;
}

/// Newton's method on (ψ, φ) at the points, the linear system being block-tridiagonal.
class Newton {
 public:
  Newton(const FoepplDisc& disc, double force, double pretension, int intervals)
      : disc_(disc), force_(force), pretension_(pretension), grid_(disc.tip, intervals), size_(intervals + 1) {
    state_.resize(size_);
    for (int i = 0; i < size_; ++i) state_[i] = start(grid_.x(i));
  }

  FoepplState run() {
    FoepplState result;
    for (result.iterations = 1; result.iterations <= 200; ++result.iterations) {
      const double change = step();
      if (!std::isfinite(change)) return result;
      if (change < 1e-11) {
        result.converged = true;
        break;
      }
    }
    result.depth = depth();
    result.rim_force = state_.back()[0];
    return result;
  }

 private:
  bool bends() const { return disc_.bending > 0; }

  /// Without bending Schwerin's ψ ∝ x^{1/3}; with it the flat sheet, whose first step is the linear plate.
  Vector2d start(double x) const {
    if (bends()) return {pretension_ * x, 0};
    const double inside = x < disc_.tip ? std::pow(x / disc_.tip, 2.0 / 3) : 1;  // ψ ∝ x under the tip
    const double schwerin = std::cbrt(9.0 / 16 * std::pow(force_ / (2 * pi), 2) * x) * inside;
    const double psi = schwerin + std::max(pretension_, 0.0) * x;
    return {psi, enclosed(disc_, force_, x) / (2 * pi * psi)};
  }

  struct Row {
    Matrix2d lower = Matrix2d::Zero(), diagonal = Matrix2d::Zero(), upper = Matrix2d::Zero();
    Vector2d residual = Vector2d::Zero();
  };

  /// Second derivative in t at point i: coefficients of the points before and after.
  std::pair<double, double> second(int i) const {
    const double before = grid_.dt(i - 0.5), after = grid_.dt(i + 0.5), here = (before + after) / 2;
    return {1 / (before * here), 1 / (after * here)};
  }

  /// What stands without derivatives, at point i. The second equation is divided by κ, or without bending by
  /// x.
  void add_local(Row& row, int i) const {
    const double x = grid_.x(i), psi = state_[i][0], phi = state_[i][1];
    row.residual +=
        Vector2d(-psi + x * phi * phi / 2,
                 (-disc_.bending * phi - x * psi * phi + x * enclosed(disc_, force_, x) / (2 * pi)) / scale(x));
    row.diagonal(0, 0) += -1;
    row.diagonal(0, 1) += x * phi;
    row.diagonal(1, 0) += -x * phi / scale(x);
    row.diagonal(1, 1) += (-disc_.bending - x * psi) / scale(x);
  }

  double scale(double x) const { return bends() ? disc_.bending : x; }

  Row inner(int i) const {
    Row row;
    const auto [before, after] = second(i);
    const Matrix2d stiffness = Vector2d(1, bends() ? 1 : 0).asDiagonal();
    row.lower = before * stiffness;
    row.upper = after * stiffness;
    row.diagonal = -(before + after) * stiffness;
    row.residual = stiffness * (before * (state_[i - 1] - state_[i]) + after * (state_[i + 1] - state_[i]));
    add_local(row, i);
    return row;
  }

  /// At the inner end ψ and φ grow as a power of x; a membrane's φ follows from ψ.
  Row centre() const {
    Row row;
    const bool point = !(disc_.tip > 0) && !bends();
    const double growth = std::exp((point ? 1.0 / 3 : 1.0) * (grid_.t(1) - grid_.t(0)));
    row.diagonal(0, 0) = -growth;
    row.upper(0, 0) = 1;
    row.residual[0] = state_[1][0] - growth * state_[0][0];
    if (bends()) {
      row.diagonal(1, 1) = -growth;
      row.upper(1, 1) = 1;
      row.residual[1] = state_[1][1] - growth * state_[0][1];
    } else {
      membrane_slope(row, 0);
    }
    return row;
  }

  void membrane_slope(Row& row, int i) const {
    const double x = grid_.x(i);
    row.residual[1] = -state_[i][0] * state_[i][1] + enclosed(disc_, force_, x) / (2 * pi);
    row.diagonal(1, 0) = -state_[i][1];
    row.diagonal(1, 1) = -state_[i][0];
  }

  /// The equation at the rim over half a cell, with ψ_t there from the clamp: ψ_t = ν ψ + (1 − ν) N0.
  Row rim() const {
    Row row;
    const int i = size_ - 1;
    const double before = grid_.dt(i - 0.5), half = (grid_.t(i) - grid_.t(i - 0.5));
    const double psi = state_[i][0], phi = state_[i][1];
    const double slope = disc_.nu * psi + (1 - disc_.nu) * pretension_;
    row.residual[0] = slope - (psi - state_[i - 1][0]) / before + half * (-psi + phi * phi / 2);
    row.lower(0, 0) = 1 / before;
    row.diagonal(0, 0) = disc_.nu - 1 / before - half;
    row.diagonal(0, 1) = half * phi;
    if (bends()) {
      row.residual[1] = phi;
      row.diagonal(1, 1) = 1;
    } else {
      membrane_slope(row, i);
    }
    return row;
  }

  Row row(int i) const { return i == 0 ? centre() : i == size_ - 1 ? rim() : inner(i); }

  /// One Newton step; returns the largest change of ψ and of φ over their largest values.
  double step() {
    std::vector<Matrix2d> upper(size_);
    std::vector<Vector2d> right(size_);
    for (int i = 0; i < size_; ++i) {
      Row r = row(i);
      if (i > 0) {
        r.diagonal -= r.lower * upper[i - 1];
        r.residual -= r.lower * right[i - 1];
      }
      const Matrix2d inverse = r.diagonal.inverse();
      upper[i] = inverse * r.upper;
      right[i] = inverse * r.residual;
    }
    for (int i = size_ - 2; i >= 0; --i) right[i] -= upper[i] * right[i + 1];
    const double damping = bends() ? 1 : keeps_tension(right);
    Eigen::Array2d change = Eigen::Array2d::Zero(), largest = Eigen::Array2d::Constant(1e-300);
    for (int i = 0; i < size_; ++i) {
      change = change.max(right[i].array().abs());
      state_[i] -= damping * right[i];
      largest = largest.max(state_[i].array().abs());
    }
    return (change / largest).maxCoeff();
  }

  /// Largest part of the step that leaves ψ positive everywhere.
  double keeps_tension(const std::vector<Vector2d>& change) const {
    double part = 1;
    for (int i = 0; i < size_; ++i)
      if (change[i][0] > 0) part = std::min(part, 0.8 * state_[i][0] / change[i][0]);
    return part;
  }

  /// ∫ φ dx = ∫ φ x dt by the trapezoidal rule in the index, whose spacing the map's derivative carries.
  double depth() const {
    double sum = 0;
    for (int i = 0; i < size_; ++i) {
      const double weight = i == 0 || i == size_ - 1 ? 0.5 : 1;
      sum += weight * state_[i][1] * grid_.x(i) * grid_.dt(i);
    }
    const bool point = !(disc_.tip > 0) && !bends();
    return sum + state_.front()[1] * grid_.x(0) / (point ? 2.0 / 3 : 2);  // the part inside the first point
  }

  FoepplDisc disc_;
  double force_, pretension_;
  Grid grid_;
  int size_;
  std::vector<Vector2d> state_;
};

}  // namespace

FoepplState solve(const FoepplDisc& disc, double force, double pretension, int intervals) {
  return Newton(disc, force, pretension, intervals).run();
}

double depth_under(const FoepplDisc& disc, double force, double pretension) {
  constexpr int coarse = 400;
  const FoepplState first = solve(disc, force, pretension, coarse), second = solve(disc, force, pretension, 2 * coarse);
  if (!first.converged || !second.converged)
    throw std::runtime_error("the Föppl–von Kármán equations did not converge");
  return (4 * second.depth - first.depth) / 3;
}

double force_at(const FoepplDisc& disc, double depth, double pretension) {
  double log_force = std::log(depth * depth * depth + pi * pretension * depth + 16 * pi * disc.bending * depth);
  double power = 1.0 / 3;  // d ln depth / d ln force, improved by secants
  double last = 0, last_miss = 0;
  for (int i = 0; i < 50; ++i) {
    const double miss = std::log(depth_under(disc, std::exp(log_force), pretension) / depth);
    if (std::abs(miss) < 1e-10) break;
    if (i > 0 && log_force != last) power = std::clamp((miss - last_miss) / (log_force - last), 0.2, 1.2);
    last = log_force;
    last_miss = miss;
    log_force -= miss / power;
  }
  return std::exp(log_force);
}

FoepplCurve::FoepplCurve(double nu, double tip) {
  const FoepplDisc disc{nu, tip, 0};
  constexpr double force = 1;  // any: the equations without bending scale
  const auto point_of = [&](double pretension) {
    const double depth = depth_under(disc, force, pretension);
    return std::pair(pretension / (depth * depth), force / (depth * depth * depth));
  };
  alpha_ = point_of(0).second;
  constexpr double small = 1e-3;
  const auto [eta_up, g_up] = point_of(small);
  const auto [eta_down, g_down] = point_of(-small);
  beta_ = (g_up - g_down) / (eta_up - eta_down) / pi;
  xi_ = {0};
  ratio_ = {1};
  for (double pretension = 1e-3; pretension < 2e3; pretension *= 1.25) {
    const auto [eta, g] = point_of(pretension);
    xi_.push_back(std::log1p(eta));
    ratio_.push_back(g / (alpha_ + beta_ * pi * eta));
  }
  curvature_.assign(xi_.size(), 0);  // natural spline: Thomas's algorithm
  std::vector<double> above(xi_.size(), 0);
  for (std::size_t i = 1; i + 1 < xi_.size(); ++i) {
    const double h0 = xi_[i] - xi_[i - 1], h1 = xi_[i + 1] - xi_[i];
    const double right = 6 * ((ratio_[i + 1] - ratio_[i]) / h1 - (ratio_[i] - ratio_[i - 1]) / h0);
    const double pivot = 2 * (h0 + h1) - h0 * above[i - 1];
    above[i] = h1 / pivot;
    curvature_[i] = (right - h0 * curvature_[i - 1]) / pivot;
  }
  for (std::size_t i = xi_.size() - 1; i-- > 1;) curvature_[i] -= above[i] * curvature_[i + 1];
}

FoepplCurve::Along FoepplCurve::reduced(double xi) const {
  const auto after = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(xi_, xi) - xi_.begin(), 1,
                                                static_cast<std::ptrdiff_t>(xi_.size()) - 1);
  const auto i = static_cast<std::size_t>(after) - 1;
  const double h = xi_[i + 1] - xi_[i], b = (xi - xi_[i]) / h, a = 1 - b, from = curvature_[i], to = curvature_[i + 1];
  return {a * ratio_[i] + b * ratio_[i + 1] + h * h / 6 * ((a * a * a - a) * from + (b * b * b - b) * to),
          (ratio_[i + 1] - ratio_[i]) / h + h / 6 * ((3 * b * b - 1) * to - (3 * a * a - 1) * from), a * from + b * to};
}

// Below 0 (a fit may look there) the first-order line goes on.
FoepplCurve::Along FoepplCurve::along(double eta) const {
  const double rise = beta_ * pi, line = alpha_ + rise * eta;
  if (eta <= 0) return {line, rise, 0};
  const Along r = reduced(std::log1p(eta));
  const double inner = 1 / (1 + eta);  // dξ/dη
  return {line * r.value, rise * r.value + line * r.first * inner,
          (2 * rise * r.first + line * (r.second - r.first) * inner) * inner};
}

double FoepplCurve::g(double eta) const { return along(eta).value; }

double FoepplCurve::slope(double eta) const { return along(eta).first; }

std::shared_ptr<const FoepplCurve> foeppl_curve(double nu, double tip) {
  static std::mutex mutex;
  static std::map<std::pair<double, double>, std::shared_ptr<const FoepplCurve>> known;
  const std::lock_guard lock(mutex);
  auto& curve = known[{nu, tip}];
  if (!curve) curve = std::make_shared<const FoepplCurve>(nu, tip);
  return curve;
}

}  // namespace validate

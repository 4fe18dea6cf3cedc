#include "compare/fitting/curve.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace validate {

namespace {

std::vector<double> usable(const Run& run, const std::vector<double>& values) {
  std::vector<double> picked;
  for (const std::size_t i : usable_points(run)) picked.push_back(values[i]);
  return picked;
}

}  // namespace

Curve::Curve(std::span<const double> depth_A, std::span<const double> force_eV_per_A) {
  gsl_set_error_handler_off();  // GSL's own handler aborts the program
  if (depth_A.size() != force_eV_per_A.size()) {
    throw std::invalid_argument("a curve needs as many forces as depths");
  }
  std::map<double, double> sorted;  // loads may be given in any order, and twice
  for (std::size_t i = 0; i < depth_A.size(); ++i) {
    const double x = std::log(depth_A[i]), y = std::log(force_eV_per_A[i]);
    if (!std::isfinite(x) || !std::isfinite(y)) {
      throw std::invalid_argument("a curve needs positive, finite depths and forces");
    }
    sorted[x] = y;
  }
  if (sorted.size() < 2) throw std::invalid_argument("a curve needs two different depths");
  for (const auto& [x, y] : sorted) {
    log_depth_.push_back(x);
    log_force_.push_back(y);
  }
  const gsl_interp_type* type =
      sorted.size() < gsl_interp_type_min_size(gsl_interp_steffen) ? gsl_interp_linear : gsl_interp_steffen;
  interpolation_.reset(gsl_interp_alloc(type, sorted.size()));
  gsl_interp_init(interpolation_.get(), log_depth_.data(), log_force_.data(), sorted.size());
}

Curve::Curve(const Run& run) : Curve(usable(run, run.depth_A), usable(run, load_values(run))) {}

double Curve::lowest_A() const { return std::exp(log_depth_.front()); }
double Curve::highest_A() const { return std::exp(log_depth_.back()); }

std::optional<double> Curve::at(double depth_A) const {
  const double rounding = 1e-12;  // a depth that was itself an end comes back through log
  const double x = std::log(depth_A);
  if (!(x >= log_depth_.front() - rounding && x <= log_depth_.back() + rounding)) return std::nullopt;
  const double inside = std::clamp(x, log_depth_.front(), log_depth_.back());
  return std::exp(gsl_interp_eval(interpolation_.get(), log_depth_.data(), log_force_.data(), inside, nullptr));
}

}  // namespace validate

#include "reference/shooting.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace reference {

namespace {

struct System {
  const Derivative& derivative;
  std::size_t size;
};

int derivative_callback(double x, const double y[], double dy_dx[], void* raw) {
  const auto& system = *static_cast<const System*>(raw);
  system.derivative(x, {y, system.size}, {dy_dx, system.size});
  return GSL_SUCCESS;
}

double root_callback(double x, void* raw) { return (*static_cast<const std::function<double(double)>*>(raw))(x); }

}  // namespace

bool integrate(const Derivative& derivative, double begin, double end, int steps, std::span<double> state) {
  System system{derivative, state.size()};
  const gsl_odeiv2_system gsl_system{derivative_callback, nullptr, state.size(), &system};
  const std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> method(
      gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, state.size()), gsl_odeiv2_step_free);
  std::vector<double> error(state.size());
  const double h = (end - begin) / steps;
  for (int i = 0; i < steps; ++i) {
    gsl_odeiv2_step_apply(method.get(), begin + i * h, h, state.data(), error.data(), nullptr, nullptr, &gsl_system);
  }
  return std::ranges::all_of(state, [](double y) { return std::isfinite(y); });
}

double root(const std::function<double(double)>& f, double low, double high) {
  auto callable = f;
  gsl_function function{root_callback, &callable};
  gsl_set_error_handler_off();  // GSL's own handler aborts the program
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  if (gsl_root_fsolver_set(solver.get(), &function, low, high) != GSL_SUCCESS)
    throw std::runtime_error("no change of sign in the bracket");
  for (int i = 0; i < 200; ++i) {
    gsl_root_fsolver_iterate(solver.get());
    const double left = gsl_root_fsolver_x_lower(solver.get()), right = gsl_root_fsolver_x_upper(solver.get());
    if (right - left <= 1e-14 * std::max(1.0, std::abs(right))) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

double positive_root(const std::function<double(double)>& f, double guess) {
  const auto in_logarithm = [&f](double t) { return f(std::exp(t)); };
  const double centre = std::log(guess);
  const double sign = in_logarithm(centre);
  for (int doublings = 1; doublings <= 150; ++doublings) {
    const double reach = doublings * std::log(2);
    for (const double side : {-reach, reach}) {
      const double inner = centre + side - std::copysign(std::log(2), side);
      if (in_logarithm(centre + side) * sign <= 0)
        return std::exp(root(in_logarithm, std::min(inner, centre + side), std::max(inner, centre + side)));
    }
  }
  throw std::runtime_error("no change of sign over the positive numbers");
}

}  // namespace reference

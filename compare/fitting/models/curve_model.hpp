// What a fit asks of a curve.
#pragma once

#include <concepts>
#include <functional>
#include <span>
#include <utility>

namespace validate {

/// A curve y = f(x; p): a struct with a fixed number of parameters, the value and the gradient over p.
template <class M>
concept CurveModel = requires(const M& model, double x, std::span<const double> parameters,
                              std::span<double> gradient) {
  { M::parameter_count } -> std::convertible_to<int>;
  { model.value(x, parameters) } -> std::convertible_to<double>;
  model.gradient(x, parameters, gradient);
};

/// A model with its type taken off, so that GSL stays in fit.cpp.
struct AnyCurveModel {
  int parameter_count = 0;
  std::function<double(double, std::span<const double>)> value;
  std::function<void(double, std::span<const double>, std::span<double>)> gradient;
};

template <CurveModel M>
AnyCurveModel any_model(M model) {
  return {M::parameter_count, [model](double x, std::span<const double> p) { return model.value(x, p); },
          [model](double x, std::span<const double> p, std::span<double> g) { model.gradient(x, p, g); }};
}

}  // namespace validate

#include "compare/fitting/models/eq16.hpp"

#include <numbers>

namespace validate {

double Eq16::q() const { return 1 / (1.05 - 0.15 * nu - 0.16 * nu * nu); }

double Eq16::force(double depth_A, double Eh, double pretension) const {
  const double parameters[] = {Eh, pretension};
  return value(depth_A, parameters);
}

double Eq16::value(double depth_A, std::span<const double> parameters) const {
  double slope[2];
  gradient(depth_A, parameters, slope);  // linear in both parameters
  return slope[0] * parameters[0] + slope[1] * parameters[1];
}

void Eq16::gradient(double depth_A, std::span<const double>, std::span<double> gradient) const {
  const double cubed = q() * depth_A;
  gradient[0] = cubed * cubed * cubed / (a_A * a_A);
  gradient[1] = std::numbers::pi * depth_A;
}

}  // namespace validate

#include "reference/plate.hpp"

#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_bessel.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace reference {

namespace {

using std::numbers::pi;
using State = Eigen::Vector4d;  // β, m, N_r, N_θ
using Block = Eigen::Matrix4d;

struct Rates {
  State slope;
  Block jacobian;
};

Rates rates(const Plate& plate, double force, double x, bool loaded, const State& y) {
  const double r = std::exp(x), D = plate.bending, c = plate.load_radius;
  const double load = force / (2 * pi) * (loaded ? r * r / (c * c) : 1);
  Rates at;
  at.slope << r * y[1] - y[0], (r * y[2] * y[0] - load) / D, y[3] - y[2], y[2] - y[3] - y[0] * y[0] / 2;
  at.jacobian << -1, r, 0, 0,            //
      r * y[2] / D, 0, r * y[0] / D, 0,  //
      0, 0, -1, 1,                       //
      -y[0], 0, 1, -1;
  return at;
}

// Nodes in x = ln r, close together at the disc's edge (node `steps`) and at the rim.
std::vector<double> mesh(double load_radius, int steps) {
  const double start = std::log(1e-4 * load_radius), edge = std::log(load_radius);
  std::vector<double> x;
  for (int i = 0; i < steps; ++i) {
    const double s = 1 - static_cast<double>(i) / steps;
    x.push_back(edge + (start - edge) * s * s);
  }
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    x.push_back(edge * (1 - s * s * (3 - 2 * s)));
  }
  return x;
}

struct Interval {
  State middle, residual;   // y1 − y0 − Simpson's rule, with the cubic Hermite polynomial in the middle
  Block by_left, by_right;  // derivatives of the residual
};

Interval interval(const Plate& plate, double force, double left, double right, bool loaded, const State& y0,
                  const State& y1) {
  const double h = right - left;
  const Rates f0 = rates(plate, force, left, loaded, y0), f1 = rates(plate, force, right, loaded, y1);
  Interval at;
  at.middle = (y0 + y1) / 2 + h / 8 * (f0.slope - f1.slope);
  const Rates fm = rates(plate, force, (left + right) / 2, loaded, at.middle);
  const Block I = Block::Identity();
  at.residual = y1 - y0 - h / 6 * (f0.slope + 4 * fm.slope + f1.slope);
  at.by_left = -I - h / 6 * (f0.jacobian + 4 * fm.jacobian * (I / 2 + h / 8 * f0.jacobian));
  at.by_right = I - h / 6 * (f1.jacobian + 4 * fm.jacobian * (I / 2 - h / 8 * f1.jacobian));
  return at;
}

// The collocation equations at the states y (one column a node), two boundary conditions first, two last.
struct Equations {
  Eigen::VectorXd residual;
  Eigen::SparseMatrix<double> jacobian;
};

Equations equations(const Plate& plate, double force, const std::vector<double>& x, const Eigen::Matrix4Xd& y) {
  const auto nodes = static_cast<Eigen::Index>(x.size()), steps = (nodes - 1) / 2, last = 4 * (nodes - 1);
  Equations at{Eigen::VectorXd(4 * nodes), {4 * nodes, 4 * nodes}};
  std::vector<Eigen::Triplet<double>> entries;
  const double r0 = std::exp(x[0]);
  at.residual.head<2>() << y(0, 0) - r0 * y(1, 0) / 2, y(2, 0) - y(3, 0);
  entries.insert(entries.end(), {{0, 0, 1.0}, {0, 1, -r0 / 2}, {1, 2, 1.0}, {1, 3, -1.0}});
  for (Eigen::Index i = 0; i + 1 < nodes; ++i) {
    const Interval part = interval(plate, force, x[i], x[i + 1], i < steps, y.col(i), y.col(i + 1));
    at.residual.segment<4>(4 * i + 2) = part.residual;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        entries.emplace_back(4 * i + 2 + row, 4 * i + column, part.by_left(row, column));
        entries.emplace_back(4 * i + 2 + row, 4 * i + 4 + column, part.by_right(row, column));
      }
    }
  }
  const State rim = y.col(nodes - 1);
  at.residual.tail<2>() << rim[0], rim[3] - plate.nu * rim[2] - (1 - plate.nu) * plate.pretension;
  entries.insert(entries.end(), {{static_cast<int>(last + 2), static_cast<int>(last), 1.0},
                                 {static_cast<int>(last + 3), static_cast<int>(last + 3), 1.0},
                                 {static_cast<int>(last + 3), static_cast<int>(last + 2), -plate.nu}});
  at.jacobian.setFromTriplets(entries.begin(), entries.end());
  return at;
}

// Newton's method from y; true once a step no longer counts beside the state.
bool solve(const Plate& plate, double force, const std::vector<double>& x, Eigen::Matrix4Xd& y) {
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factor;
  for (int i = 0; i < 12; ++i) {
    const Equations at = equations(plate, force, x, y);
    factor.compute(at.jacobian);
    if (factor.info() != Eigen::Success) return false;
    const Eigen::VectorXd step = factor.solve(at.residual);
    if (!step.allFinite()) return false;
    const Eigen::Map<const Eigen::Matrix4Xd> change(step.data(), 4, y.cols());
    y -= change;
    const Eigen::Array4d size = y.cwiseAbs().rowwise().maxCoeff(), moved = change.cwiseAbs().rowwise().maxCoeff();
    if ((moved <= 1e-10 * size).all()) return true;
  }
  return false;
}

// Depths and energy by Simpson's rule on the same polynomials.
PlateState measure(const Plate& plate, double force, const std::vector<double>& x, const Eigen::Matrix4Xd& y) {
  const double D = plate.bending, nu = plate.nu, c = plate.load_radius, N0 = plate.pretension;
  const auto energy_rate = [&](double at, const State& s) {
    const double stretching = (s[2] * s[2] + s[3] * s[3] - 2 * nu * s[2] * s[3]) / 2 - (1 - nu) * N0 * N0;
    return 2 * pi * std::exp(2 * at) * (D * s[1] * s[1] / 2 + stretching);
  };
  const auto nodes = static_cast<Eigen::Index>(x.size()), steps = (nodes - 1) / 2;
  // w(0) − w, which starts as r β/2; its ∫ r dr over the loaded disc.
  double drop = std::exp(x[0]) * y(0, 0) / 2, moment = 0, energy = 0;
  for (Eigen::Index i = 0; i + 1 < nodes; ++i) {
    const double h = x[i + 1] - x[i], middle = (x[i] + x[i + 1]) / 2;
    const State ym = interval(plate, force, x[i], x[i + 1], i < steps, y.col(i), y.col(i + 1)).middle;
    const double d0 = std::exp(x[i]) * y(0, i), dm = std::exp(middle) * ym[0], d1 = std::exp(x[i + 1]) * y(0, i + 1);
    const double drop_after = drop + h / 6 * (d0 + 4 * dm + d1);
    const double drop_middle = (drop + drop_after) / 2 + h / 8 * (d0 - d1);
    if (i < steps) {
      moment +=
          h / 6 *
          (std::exp(2 * x[i]) * drop + 4 * std::exp(2 * middle) * drop_middle + std::exp(2 * x[i + 1]) * drop_after);
    }
    energy += h / 6 * (energy_rate(x[i], y.col(i)) + 4 * energy_rate(middle, ym) + energy_rate(x[i + 1], y.col(i + 1)));
    drop = drop_after;
  }
  return {drop, drop - 2 * moment / (c * c), y(2, nodes - 1), energy};
}

}  // namespace

PlateState plate(const Plate& plate, double force, int steps) {
  const std::vector<double> x = mesh(plate.load_radius, steps);
  Eigen::Matrix4Xd y = Eigen::Matrix4Xd::Zero(4, static_cast<Eigen::Index>(x.size()));
  y.bottomRows<2>().setConstant(plate.pretension);
  double reached = 0;
  double next = std::min(force, 16 * pi * plate.bending * std::sqrt(plate.bending));  // as deep as it is thick
  while (reached < force) {
    Eigen::Matrix4Xd trial = y;
    if (reached > 0) {
      trial.topRows<2>() *= std::cbrt(next / reached);
      trial.bottomRows<2>() *= std::pow(next / reached, 2.0 / 3);
    }
    if (solve(plate, next, x, trial)) {
      y = trial;
      reached = next;
      next = std::min(force, 2 * reached);
    } else {
      next = reached > 0 ? std::sqrt(next * reached) : next / 10;
      if (next < 1.001 * reached || next < 1e-12 * force) throw std::runtime_error("the plate did not converge");
    }
  }
  return measure(plate, force, x, y);
}

double tight_plate_stiffness(double bending, double pretension) {
  // β = F/(2π N0) (1/r − l K1(l r) − (1 − l K1(l)) I1(l r)/I1(l)), l² = N0/D; delta = ∫ β dr.
  const double l = std::sqrt(pretension / bending);
  const double I0 = gsl_sf_bessel_I0_scaled(l), I1 = gsl_sf_bessel_I1_scaled(l), unit = std::exp(-l);
  const double K0 = gsl_sf_bessel_K0(l), K1 = gsl_sf_bessel_K1(l);
  return 2 * pi * pretension / (K0 + std::log(l / 2) + M_EULER - (1 - l * K1) * (I0 - unit) / (l * I1));
}

}  // namespace reference

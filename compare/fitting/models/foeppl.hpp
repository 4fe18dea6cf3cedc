// The shallow clamped disc under a tip: Föppl–von Kármán equations in one dimension, with or without bending.
#pragma once

#include <memory>
#include <vector>

namespace validate {

/// A clamped disc of radius a in units of a and E·h. Forces are F/(E·h a), membrane forces N/(E·h), depths
/// w/a.
///
/// With x = r/a, t = ln x, ψ = x N_r and the slope φ = dw/dx:
///   ψ_tt − ψ = −½ x φ²,   κ (φ_tt − φ) = x (ψ φ − F(x)/2π),
/// rim: ψ_t − ν ψ = (1 − ν) N0 and, with bending, φ = 0. F(x) is the load inside x. Slopes are small
/// against 1. Source: Landau & Lifshitz, Theory of Elasticity, § 14; Vella & Davidovitch, Soft Matter 13
/// (2017) 2264.
struct FoepplDisc {
  double nu = 0;
  double tip = 0;      ///< radius of the uniformly loaded disc; 0: a point; 1: uniform pressure
  double bending = 0;  ///< κ/(E·h a²)
};

struct FoepplState {
  bool converged = false;
  int iterations = 0;
  double depth = 0;      ///< w at the centre
  double rim_force = 0;  ///< N_r at the rim
};

/// Equilibrium under a force. Second order in the spacing of `intervals` pieces of t, refined towards the
/// rim.
FoepplState solve(const FoepplDisc& disc, double force, double pretension, int intervals);

/// Depth under a force, extrapolated from two grids: right to about 1e-7 of itself without bending.
/// Throws std::runtime_error where Newton's method does not converge.
double depth_under(const FoepplDisc& disc, double force, double pretension);

/// The inverse: force at a depth.
double force_at(const FoepplDisc& disc, double depth, double pretension);

/// Without bending, F/(E·h a) = d³ g(N0/(E·h d²)) with d = depth/a: one function holds every curve of a
/// geometry. Tabulated once, then interpolated (error below 1e-5).
class FoepplCurve {
 public:
  FoepplCurve(double nu, double tip);

  double alpha() const { return alpha_; }  ///< g(0):  F = α E·h δ³/a² without pretension
  double beta() const { return beta_; }    ///< g′(0)/π:  F ≈ α E·h δ³/a² + β π σ0h δ at first order

  double g(double eta) const;
  double slope(double eta) const;  ///< dg/dη

  struct Along {
    double value = 0, first = 0, second = 0;
  };
  Along along(double eta) const;  ///< g and its derivatives

 private:
  Along reduced(double xi) const;  // g/(α + βπη) over ln(1 + η)
  double alpha_ = 0, beta_ = 0;
  std::vector<double> xi_, ratio_, curvature_;  // of a natural cubic spline
};

/// One table per geometry and process; for any number of threads.
std::shared_ptr<const FoepplCurve> foeppl_curve(double nu, double tip);

}  // namespace validate

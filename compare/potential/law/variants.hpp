// Other forms of a potential's law beside the polynomial in use, and what the choice of form does to a force.
#pragma once

#include <string>
#include <vector>

#include "compare/potential/law/calibrated_law.hpp"
#include "membrane/laws/list.hpp"

namespace validate {

/// The law as a table in I and q (cubic splines), fitted to the same states. Throws std::invalid_argument where they
/// are too few.
membrane::CauchyBornTable calibrate_table(const atomistic::Card& card,
                                          const std::vector<atomistic::HomogeneousState>& states,
                                          const CalibrationRange& range);

/// The law with the lattice's directions: the polynomial's terms and those in cos 6θ, cos² 6θ and of the knots, fitted
/// to the states along zigzag, armchair and between. Zigzag along x. Throws as above.
membrane::CauchyBornSixfold calibrate_sixfold(const atomistic::Card& card,
                                              const std::vector<atomistic::HomogeneousState>& states,
                                              const CalibrationRange& range);

/// A form, how well it gives the lattice's membrane forces (all components, relative, as in CalibratedLaw), and how far
/// a disc of 10 Å on a sheet of 110 Å feels the difference from the form it is compared with.
struct LawVariant {
  std::string name;
  std::size_t coefficients = 0;
  double rms_misfit = 0, worst_misfit = 0;
  double force_difference = 0;  ///< largest relative one, depths from 0.05 to 0.25 of the radius
};

/// Degrees 5 to 8 and the table against the table, in one dimension with bending; the sixfold form against degree 8, on
/// triangles without.
std::vector<LawVariant> law_variants(const atomistic::Card& card,
                                     const std::vector<atomistic::HomogeneousState>& states,
                                     const CalibrationRange& range);

/// Force of the sixfold membrane over that of the isotropic one at equal controlled depths of a disc load, on
/// triangles.
std::vector<double> anisotropy_ratios(const CalibratedLaw& law, double radius_A, double tip_A,
                                      const std::vector<double>& depths_A);

}  // namespace validate

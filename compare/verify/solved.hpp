// Solves the membrane problems that the groups pose.
#pragma once

#include <vector>

#include "membrane/problem.hpp"

namespace validate::verify {

/// One step per level. Throws std::runtime_error with the solver's reason where a level is not reached.
std::vector<membrane::Step> solved(const membrane::Problem& problem);

/// The same, of the last level.
membrane::Step solved_last(const membrane::Problem& problem);

/// A clamped disc of St Venant–Kirchhoff's law, without prestress, on a quarter with graded rings.
membrane::Problem round_sheet(double radius_A, double modulus_eV_per_A2, double nu, int rings);

/// Prestress σ in every direction.
inline Eigen::Matrix2d isotropic(double sigma) { return sigma * Eigen::Matrix2d::Identity(); }

}  // namespace validate::verify

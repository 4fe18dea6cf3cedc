// Dead forces that pull a disc's rim outwards in its plane.
#pragma once

#include <Eigen/Core>

#include "atomistic/lattice/sheet.hpp"

namespace atomistic {

/// On the free atoms, three components each (eV/Å): the whole force is 2π r̄ T, r̄ the mean radius of the atoms that
/// slide. Each of these gets the share of the circle that is nearer to it than to the next ones, along its radius in
/// the flat sheet. Zero for a tension of 0. Throws std::invalid_argument where no atom slides.
Eigen::VectorXd rim_pull(const Sheet& sheet, double tension_eV_per_A2);

/// Mean radius of the atoms that slide, Å.
double rim_radius_A(const Sheet& sheet);

/// Mean displacement of the atoms that slide along their radii in the flat sheet, Å.
double rim_displacement_A(const Sheet& sheet, const Eigen::VectorXd& positions);

}  // namespace atomistic

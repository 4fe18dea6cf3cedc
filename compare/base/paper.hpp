// The cases of Gil, Adhikari, Scarpa & Bonet, J. Phys.: Condens. Matter 22 (2010) 145302.
#pragma once

#include "compare/base/units.hpp"

namespace validate::paper {

// Figures 2 to 4: constants of its reference [30]; of the same as a shell, κ = E h³/12(1 − ν²).
inline constexpr double E_eV_per_A3 = 5.864, thickness_A = 1.37, nu = 0.19, shell_bending_eV = 1.30;
inline constexpr double Eh_eV_per_A2 = E_eV_per_A3 * thickness_A;

// Figures 2 and 3: a clamped disc under a point, or a disc of 10 Å.
inline constexpr double radius_A = 110, tip_A = 10;

// Figure 4: a square whose edges slide in their plane, under a follower pressure.
inline constexpr double side_A = 220, pressure_eV_per_A3 = 5.16529e-4;

// Figure 1: suspended graphene of Lee, Wei, Kysar & Hone, Science 321 (2008) 385.
namespace suspended {
inline constexpr double Eh_N_per_m = 342, Eh_spread_N_per_m = 30, pretension_N_per_m = 0.34, nu = 0.165;
inline constexpr double Eh_eV_per_A2 = Eh_N_per_m / N_per_m_per_eV_per_A2,
                        pretension_eV_per_A2 = pretension_N_per_m / N_per_m_per_eV_per_A2;
inline constexpr double radius_A = 5000, wide_radius_A = 7500, tip_A = 165, wide_tip_A = 275;
}  // namespace suspended

}  // namespace validate::paper

// The cases of Gil, Adhikari, Scarpa & Bonet, J. Phys.: Condens. Matter 22 (2010) 145302.
#pragma once

namespace validate::paper {

// Figures 2 to 4: constants of its reference [30].
inline constexpr double E_eV_per_A3 = 5.864, thickness_A = 1.37, nu = 0.19;
inline constexpr double Eh_eV_per_A2 = E_eV_per_A3 * thickness_A;

// Figures 2 and 3: a clamped disc under a point, or a disc of 10 Å.
inline constexpr double radius_A = 110, tip_A = 10;

// Figure 4: a square whose edges slide in their plane, under a follower pressure.
inline constexpr double side_A = 220, pressure_eV_per_A3 = 5.16529e-4;

}  // namespace validate::paper

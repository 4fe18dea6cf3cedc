// The flat sheet at a temperature: its lattice constant and moduli, by the phonons of its cell.
#pragma once

#include <string>
#include <vector>

#include "atomistic/problem.hpp"
#include "atomistic/response.hpp"
#include "atomistic/temperature.hpp"

namespace atomistic {

/// Flexural waves longer than this are left to the sheet that they run in: how far they soften it depends on its size
/// and its tension, and without either they soften it without bound.
inline constexpr double longest_cell_wave_A = 16;

/// The lattice constant is where the free energy E + Φ of a flat cell has its minimum, C11 and C12 are its second
/// derivatives there. NaN: a lattice constant where there is no such minimum within 2 %, since vibrations are unstable;
/// moduli where the vibrations have a kink. On the calling rank alone.
WarmCard compute_warm_card(const Potential& potential, const Card& card, const Heat& heat, const std::string& log_file);

/// Free energy of the vibrations per reference area (eV/Å²) under each strain, less that of the unstrained sheet; NaN
/// where one of them is unstable.
std::vector<double> vibrations_under_strain(const Potential& potential, const Card& card, const Heat& heat,
                                            const std::vector<StrainState>& strains, const std::string& log_file);

}  // namespace atomistic

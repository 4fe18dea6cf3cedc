// The potential card: linear response of flat graphene, computed on periodic cells.
#pragma once

#include <string>

#include "atomistic/problem.hpp"

namespace atomistic {

/// Lattice constant from the zero of the membrane force; C11, C12, C66 by central differences of the second
/// Piola–Kirchhoff membrane force with the inner displacement relaxed; bending modulus of a long ripple along
/// zigzag and armchair; the margins of a clamp. On the calling rank alone. Throws std::runtime_error where the
/// potential gives no stable flat sheet.
Card compute_card(const Potential& potential, const std::string& log_file);

}  // namespace atomistic

// Computes how the flat sheet answers large homogeneous strain.
#pragma once

#include <string>
#include <vector>

#include "atomistic/problem.hpp"
#include "atomistic/response.hpp"

namespace atomistic {

/// The three curves, and the states asked for. On the calling rank alone. Throws std::invalid_argument for a strain
/// that turns the cell inside out.
Response compute_response(const Potential& potential, const Card& card, const std::vector<StrainState>& strains,
                          const std::string& log_file);

}  // namespace atomistic

// What `validate verify atoms` and `validate verify calibration` verify. A new group is a function here and a line in
// groups.cpp.
#pragma once

#include <memory>
#include <vector>

#include "compare/verify/groups.hpp"
#include "compare/verify_atoms/laboratory.hpp"

namespace validate::verify {

void verify_forces(Ledger& ledger, Laboratory& laboratory);
void verify_curve(Ledger& ledger, Laboratory& laboratory);
void verify_equilibrium(Ledger& ledger, Laboratory& laboratory);
void verify_constants(Ledger& ledger, Laboratory& laboratory);

void verify_law(Ledger& ledger, Laboratory& laboratory);
void verify_lattice(Ledger& ledger, Laboratory& laboratory);
void verify_small_strain(Ledger& ledger, Laboratory& laboratory);
void verify_bending_modulus(Ledger& ledger, Laboratory& laboratory);

/// Groups that work in the laboratory, which they keep.
std::vector<Group> atoms_groups(const std::shared_ptr<Laboratory>& laboratory);
std::vector<Group> calibration_groups(const std::shared_ptr<Laboratory>& laboratory);

}  // namespace validate::verify

// What `validate verify membrane` verifies, group by group. A new group is a function here and a line in
// groups.cpp.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "compare/verify/ledger.hpp"

namespace validate::verify {

void verify_laws(Ledger& ledger);
void verify_patch(Ledger& ledger);
void verify_point(Ledger& ledger);
void verify_disc(Ledger& ledger);
void verify_sphere(Ledger& ledger);
void verify_bending(Ledger& ledger);
void verify_pressure(Ledger& ledger);
void verify_wrinkling(Ledger& ledger);
void verify_figure4(Ledger& ledger);
void verify_pulled_rim(Ledger& ledger);

struct Group {
  std::string_view name, what;
  std::function<void(Ledger&)> run;
};

std::span<const Group> groups();

/// Of `validate verify wrinkles`.
std::span<const Group> wrinkles_groups();

/// The rows of a group. A case that does not converge ends its group with a failing row that says why.
std::vector<VerificationRow> run(const Group& group, const OnRow& on_row);

}  // namespace validate::verify

// Tables of a page whose columns can be sorted, where the terminal has text.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// What a command that is no experiment found, as tables; of a fit and a card what the terminal shows is folded away
/// below.
std::string tables_of(const Result& result);

/// A sheet under pressures, pressure by pressure, and its atoms beside it; empty where no pressure acted.
std::string pressed_tables(const Result& result);

}  // namespace validate

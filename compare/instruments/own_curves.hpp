// curves.csv of this program: one curve a run.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat own_curves_format;

}  // namespace validate

// Any table of numbers: separator, decimal sign, header and units are found out.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat delimited_format;

}  // namespace validate

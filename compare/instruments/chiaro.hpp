// Text of Optics11's Chiaro indenter.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat chiaro_format;

}  // namespace validate

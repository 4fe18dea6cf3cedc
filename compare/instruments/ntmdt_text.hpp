// NT-MDT's text: three columns of numbers without a header.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat ntmdt_text_format;

}  // namespace validate

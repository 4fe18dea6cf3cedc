// The table that afmformats writes: metadata as JSON in comments.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat afmformats_tab_format;

}  // namespace validate

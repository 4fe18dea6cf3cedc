// Nanosurf's .nid: a text of sections, and behind "#!" the binary data sets.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat nanosurf_format;

}  // namespace validate

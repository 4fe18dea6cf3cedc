// AFM Workshop's comma-separated values: one curve a file, a map as a folder or zip of them.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat afm_workshop_format;

}  // namespace validate

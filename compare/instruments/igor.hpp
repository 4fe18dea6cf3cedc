// Igor Pro's binary wave, version 5: .ibw of Asylum Research's instruments.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat igor_format;

}  // namespace validate

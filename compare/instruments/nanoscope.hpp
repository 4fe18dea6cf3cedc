// NanoScope's binary force curves (.spm, .000): Bruker, Veeco, Digital Instruments.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat nanoscope_format;

}  // namespace validate

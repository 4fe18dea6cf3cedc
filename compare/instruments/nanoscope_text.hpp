// NanoScope's text export: its header in quotes, columns _Ex and _Rt beside each other.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat nanoscope_text_format;

}  // namespace validate

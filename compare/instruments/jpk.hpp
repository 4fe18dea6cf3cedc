// JPK: .jpk-force, .jpk-force-map, .jpk-qi-data, .jpk-qi-series, zip archives of headers and channels.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat jpk_format;

}  // namespace validate

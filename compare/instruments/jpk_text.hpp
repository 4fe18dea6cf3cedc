// JPK's text export: a block of rows for each segment, described by comments.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat jpk_text_format;

}  // namespace validate

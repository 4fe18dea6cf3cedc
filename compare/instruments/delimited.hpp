// Any table of numbers: separator, decimal sign, header and units are found out.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat delimited_format;

/// The one recording of a text with a table: what remarks say of it, columns by their headings. Throws Error (bad
/// input).
Recording read_delimited(const FileContent& file, std::string_view format);

}  // namespace validate

// HDF5: afmformats' files, this program's, and any whose groups hold columns with units.
#pragma once

#include "compare/instruments/format.hpp"

namespace validate {

extern const InstrumentFormat columns_h5_format;

}  // namespace validate

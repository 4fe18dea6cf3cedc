// A sheet that is pressed through a cantilever.
#pragma once

#include "compare/fitting/force_model.hpp"

namespace validate {

/// Force over the position z of the cantilever's base (Å, from the contact on): F(z) = F_sheet(d) with d = z − F/k;
/// `compliance` is 1/k in Å²/eV. Derivatives over E·h and pretension are at z. Asked in order of z it costs about as
/// much as the sheet alone; a curve belongs to one thread. NaN where a sheet that pulls itself in has no such place.
ForceCurve in_series(ForceCurve sheet, double compliance);

}  // namespace validate

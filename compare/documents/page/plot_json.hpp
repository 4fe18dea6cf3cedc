// A drawing as the page's script reads it: the plot model without its maps.
#pragma once

#include <string>

#include "compare/documents/plots/plot.hpp"

namespace validate {

/// Whether the script can draw it: it has panels, and none of them is seen from above.
bool is_chart(const Plot& plot);

/// JSON with six digits a number, null where one is not known. A curve without a place in the legend belongs to the
/// entry of its name, if there is one.
std::string plot_json(const Plot& plot);

}  // namespace validate

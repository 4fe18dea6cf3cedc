#include "compare/documents/plots/design_plot.hpp"

#include <fmt/format.h>

#include <cmath>

namespace validate {

Plot design_plot(const Design& design) {
  constexpr double per_cent = 100;
  Panel panel{.title = "expected error of E·h",
              .x = {.label = "", .key = "experiment"},
              .y = {.label = "standard error of E·h", .unit = "%", .key = "Eh_stderr_percent", .low = 0}};
  StackedBars bars{.name = "error of E·h", .colour = colour_of_membrane};
  for (std::size_t i = 0; i < design.rows.size(); ++i) {
    panel.x.categories.push_back(fmt::format("{}", i));
    bars.y.push_back(per_cent * design.rows[i].Eh_stderr_relative);
  }
  panel.x.label = "0: as asked for; the changes in the order of the table";
  panel.bars.push_back(std::move(bars));
  if (std::isfinite(design.target_relative))
    panel.marks.push_back({.along = Along::y,
                           .at = per_cent * design.target_relative,
                           .dash = Dash::dashed,
                           .colour = Colour::vermilion});
  return {.panels = {std::move(panel)}, .width = 900, .height = 420};
}

}  // namespace validate

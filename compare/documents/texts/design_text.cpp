#include "compare/documents/texts/design_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

constexpr double per_cent = 100;

void add_sources(std::string& text, const DesignRow& row) {
  double total = 0;
  for (const ErrorSource& source : row.sources) total += std::pow(source.Eh_eV_per_A2, 2);
  const char* separator = "  errors of E·h come from: ";
  for (const ErrorSource& source : row.sources) {
    const double share = std::pow(source.Eh_eV_per_A2, 2) / total;
    if (!(share > 0.01)) continue;
    fmt::format_to(std::back_inserter(text), "{}{} {:.0f} %", separator, source.name, per_cent * share);
    separator = ", ";
  }
  text += '\n';
}

}  // namespace

std::string design_text(const Design& design) {
  const DesignRow& asked = design.rows.front();
  std::string text = fmt::format(
      "E·h = {:.4g} N/m, pretension = {:.3g} N/m, drum of {:.4g} nm, to {:.4g} nm and {:.4g} nN, {} points, {} "
      "curve{}\n"
      "expected: E·h ± {:.2g} N/m ({:.2f} %), pretension ± {:.2g} N/m\n",
      in_N_per_m(design.Eh_eV_per_A2), in_N_per_m(design.pretension_eV_per_A2), asked.radius_A / 10, asked.depth_A / 10,
      asked.force_eV_per_A * nN_per_eV_per_A, asked.points, asked.curves, asked.curves == 1 ? "" : "s",
      in_N_per_m(asked.Eh_stderr_eV_per_A2), per_cent * asked.Eh_stderr_relative,
      in_N_per_m(asked.pretension_stderr_eV_per_A2));
  add_sources(text, asked);
  const bool has_target = std::isfinite(design.target_relative);
  if (asked.reaches)
    return text + fmt::format("the target of {:.3g} % is reached\n", per_cent * design.target_relative);
  if (has_target)
    text += fmt::format("for {:.3g} % one of these alone:\n", per_cent * design.target_relative);
  else
    text += "with one thing changed:\n";
  for (std::size_t i = 1; i < design.rows.size(); ++i) {
    const DesignRow& row = design.rows[i];
    fmt::format_to(std::back_inserter(text), "  {:<62} {:6.2f} % {:>10} nN{}\n", row.what,
                   per_cent * row.Eh_stderr_relative, number(row.force_eV_per_A * nN_per_eV_per_A, "{:.4g}"),
                   has_target && !row.reaches ? "   not enough" : "");
  }
  return text;
}

}  // namespace validate

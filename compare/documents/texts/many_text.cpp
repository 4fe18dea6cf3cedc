#include "compare/documents/texts/many_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "compare/documents/texts/numbers.hpp"

namespace validate {
namespace {

/// Up to its first colon: the kind of a reason.
std::string kind_of(const std::string& reason) { return reason.substr(0, reason.find(':')); }

void add_mean(std::string& text, const SpreadMean& m) {
  if (m.count < 2) return;
  fmt::format_to(std::back_inserter(text),
                 "  mean of {} {}: E·h {:.1f} ± {:.1f} N/m; one has ± {:.1f} by its noise, they differ by ± {:.1f}; "
                 "pretension {:.3f} N/m, ± {:.3f} and ± {:.3f}\n",
                 m.count, m.of, in_N_per_m(m.Eh_eV_per_A2), in_N_per_m(m.Eh_stderr_eV_per_A2),
                 in_N_per_m(m.Eh_within_eV_per_A2), in_N_per_m(m.Eh_between_eV_per_A2),
                 in_N_per_m(m.pretension_eV_per_A2), in_N_per_m(m.pretension_within_eV_per_A2),
                 in_N_per_m(m.pretension_between_eV_per_A2));
}

void add_joint(std::string& text, const JointFit& joint) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  one E·h for all {} curves ({} drum{}): {:.2f} ± {:.2f} N/m (95 %: {:.2f} … {:.2f})\n",
                 joint.curves, joint.drums, joint.drums == 1 ? "" : "s", in_N_per_m(joint.Eh_eV_per_A2),
                 in_N_per_m(joint.Eh_stderr_eV_per_A2), in_N_per_m(joint.Eh_interval_eV_per_A2[0]),
                 in_N_per_m(joint.Eh_interval_eV_per_A2[1]));
  for (const JointSource& source : joint.sources)
    if (source.Eh_eV_per_A2 > 0.05 * joint.Eh_stderr_eV_per_A2)
      fmt::format_to(out, "    {}: ± {:.2f} N/m, {}\n", source.name, in_N_per_m(source.Eh_eV_per_A2),
                     source.name == "radius" && source.falls ? "which more drums make smaller"
                     : source.falls                          ? "which more curves make smaller"
                                                             : "which no repeating makes smaller");
  if (joint.chi2_per_dof > 1.5)
    fmt::format_to(
        out,
        "    warning: the curves' own E·h scatter more about it than their noise (χ²/ν {:.2f}): the mean with "
        "its spread says more\n",
        joint.chi2_per_dof);
}

}  // namespace

std::string many_text(const ManyCurves& many) {
  std::map<std::string, int> skipped;
  int used = 0;
  for (const CurveRow& row : many.rows) row.skipped.empty() ? ++used : ++skipped[kind_of(row.skipped)];
  std::string text = fmt::format("{} curves, {} used\n", many.rows.size(), used);
  for (const auto& [reason, count] : skipped)
    fmt::format_to(std::back_inserter(text), "  {} skipped: {}\n", count, reason);
  for (const SpreadMean& mean : many.means) add_mean(text, mean);
  for (const JointFit& joint : many.joint) add_joint(text, joint);
  return text;
}

}  // namespace validate

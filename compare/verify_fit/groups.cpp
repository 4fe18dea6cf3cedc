#include "compare/verify_fit/groups.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/base/units.hpp"
#include "compare/fitting/sheet_table.hpp"
#include "compare/verify_fit/trials.hpp"

namespace validate::verify {
namespace {

/// As far as any of the cases goes: a contact 25 nm too early, and pretensions of an interval's end.
TableRange range_of(const KnownCurve& truth) {
  return {1200, truth.Eh_eV_per_A2(), 1.5 / N_per_m_per_eV_per_A2 / truth.Eh_eV_per_A2()};
}

bool same_tip(const MembraneTip& a, const MembraneTip& b) {
  return a.is_sphere() == b.is_sphere() && a.tip_A == b.tip_A;
}

/// Every known curve that is wanted, with one table a tip.
void try_all(Ledger& ledger, const Experiment& experiment, int curves,
             const std::function<bool(const MembraneTip&)>& wanted) {
  std::optional<MembraneTip> tabulated;
  ForceModel table;
  std::vector<UncertainInput> inputs;
  std::uint32_t seed = 1;
  for (const KnownCurve& truth : known_curves()) {
    ++seed;
    if (!wanted(truth.tip())) continue;
    if (!tabulated || !same_tip(*tabulated, truth.tip())) {
      tabulated = truth.tip();
      table = sheet_table(*tabulated, range_of(truth));
      inputs.clear();
      if (experiment.force_error > 0) inputs.push_back({"force", scaled(table, 1 + experiment.force_error)});
      if (experiment.radius_error > 0) {
        MembraneTip larger = *tabulated;
        larger.a_A *= 1 + experiment.radius_error;
        inputs.push_back({"radius", with_tip(table, *tabulated, larger, range_of(truth))});
      }
    }
    add_rows(ledger, truth, try_fits(truth, table, inputs, experiment, curves, seed));
  }
}

bool any_tip(const MembraneTip&) { return true; }
bool disc(const MembraneTip& tip) { return !tip.is_sphere() && tip.tip_A > 100; }
/// Its own radius, which would have to be larger with the drum's, does not count.
bool almost_point(const MembraneTip& tip) { return !tip.is_sphere() && tip.tip_A < 100; }

}  // namespace

std::vector<Group> fit_groups(bool full) {
  const int curves = full ? 3000 : 80;
  const auto group = [curves](std::string_view name, std::string_view what, Experiment experiment,
                              bool (*wanted)(const MembraneTip&)) {
    return Group{name, what, [=](Ledger& ledger) { try_all(ledger, experiment, curves, wanted); }};
  };
  return {
      group("zeros", "contact and force zero known, noise known: three tips, three pretensions", {}, any_tip),
      group("free", "contact and force zero sought with the rest: three tips, three pretensions", {.zeros_free = true},
            any_tip),
      group("noise", "noise and zeros sought with the rest: a disc, three pretensions",
            {.zeros_free = true, .noise_known = false}, disc),
      group("inputs", "radius known to 1 %, forces to 3 %: three pretensions",
            {.radius_error = 0.01, .force_error = 0.03}, almost_point),
  };
}

}  // namespace validate::verify

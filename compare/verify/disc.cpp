// Uniform load over a disc at the centre of a clamped disc.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compare/base/paper.hpp"
#include "compare/verify/groups.hpp"
#include "compare/verify/solved.hpp"

namespace validate::verify {
namespace {

using namespace membrane;
using std::numbers::pi;

const std::string meshes = "36 and 72 graded rings";

template <class Measure>
MeshPair on_both(Problem problem, Measure measure) {
  const auto with = [&](int rings) {
    std::get<DiscSheet>(problem.sheet).rings = rings;
    return measure(solved_last(problem));
  };
  const double coarse = with(36);
  return {coarse, with(72), meshes};
}

Problem paper_sheet() { return round_sheet(paper::radius_A, paper::Eh_eV_per_A2, paper::nu, 36); }

/// The paper's second case.
void paper_case(Ledger& ledger) {
  Problem problem = paper_sheet();
  problem.load = DiscLoad{paper::tip_A};
  problem.control = Control::force;
  for (const char* depth : {"10", "30", "60"}) {
    const Reference force = tabulated(fmt::format("case2_disc10.force_at_{}_A", depth));
    problem.levels = {force.value};
    ledger.begin(fmt::format("paper's case 2, disc of 10 A, {} A deep", depth));
    ledger.converging("centre depth, A", on_both(problem, [](const Step& step) { return step.depth_A; }),
                      {std::stod(depth), force.origin}, 2, 0.01);
  }
}

void of_record(Ledger& ledger) {
  Problem problem = paper_sheet();
  problem.prestress_eV_per_A2 = isotropic(0.02);
  problem.load = DiscLoad{11};
  problem.control = Control::force;
  problem.levels = {20};
  ledger.begin("pretension 0.02 eV/A^2, disc of 11 A, 20 eV/A");
  ledger.converging("centre depth, A", on_both(problem, [](const Step& step) { return step.depth_A; }),
                    tabulated("disc_of_record.depth_at_20_eV/A"), 2, 0.01);
}

/// Linear membrane, F/d = 2 pi N0/(ln(a/c) + 1/2), at a depth where stretching adds some 1e-7.
void shallow(Ledger& ledger) {
  for (const double ratio : {0.02, 0.0909}) {
    Problem problem = round_sheet(paper::radius_A, 8, paper::nu, 36);
    problem.load = DiscLoad{ratio * paper::radius_A};
    problem.levels = {0.005};
    problem.prestress_eV_per_A2 = isotropic(0.1);
    ledger.begin(fmt::format("pretension alone, c = {} a", ratio));
    const double log = std::log(1 / ratio);
    ledger.converging("F/(N0 d), centre",
                      on_both(problem, [](const Step& s) { return s.force_eV_per_A / (0.1 * s.depth_A); }),
                      closed_form(2 * pi / (log + 0.5), "2 pi/(ln(a/c) + 1/2)"), 2, 0.01);
    ledger.converging("F/(N0 d), conjugate",
                      on_both(problem, [](const Step& s) { return s.force_eV_per_A / (0.1 * s.conjugate_depth_A); }),
                      closed_form(2 * pi / (log + 0.25), "2 pi/(ln(a/c) + 1/4)"), 2, 0.01);
  }
}

void balance(Ledger& ledger) {
  Problem problem = paper_sheet();
  problem.load = DiscLoad{paper::tip_A};
  problem.levels = {20};
  ledger.begin("disc of 10 A, 20 A deep");
  const Step step = solved_last(problem);
  ledger.equal("rim reaction / load", step.support_force_eV_per_A.z() / step.force_eV_per_A,
               identity(1, "balance of forces"), 1e-8);
}

/// r_(k+1) ~ r_k²: from the last three residuals above rounding, with a new tangent at each step.
void newton(Ledger& ledger) {
  Problem problem = paper_sheet();
  problem.load = DiscLoad{paper::tip_A};
  problem.levels = {20};
  problem.discretisation = Triangles{.relative_residual = 1e-12, .keep_factor = false};
  std::vector<double> r = solved_last(problem).on_triangles().residual_history;
  const std::string series = fmt::format("relative residuals {:.0e}", fmt::join(r, ", "));
  while (r.size() > 3 && r.back() < 1e-11) r.pop_back();
  const auto fall = [&](std::size_t back) { return std::log(r[r.size() - back] / r[r.size() - back - 1]); };
  ledger.begin("Newton's method, disc of 10 A, 20 A deep");
  ledger.at_least("order of its end", fall(1) / fall(2), identity(1.7, "quadratic: 2 in the limit"), series);
}

}  // namespace

void verify_disc(Ledger& ledger) {
  paper_case(ledger);
  of_record(ledger);
  shallow(ledger);
  balance(ledger);
  newton(ledger);
}

}  // namespace validate::verify

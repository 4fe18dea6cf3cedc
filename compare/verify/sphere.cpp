// Rigid frictionless sphere on a clamped disc.
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

namespace sheet = paper::suspended;
constexpr double nN = 1 / nN_per_eV_per_A;  // eV/Å

/// The sheet of the paper's first case.
Problem case1(double tip_A, int rings) {
  Problem problem = round_sheet(sheet::radius_A, sheet::Eh_eV_per_A2, sheet::nu, rings);
  problem.prestress_eV_per_A2 = isotropic(sheet::pretension_eV_per_A2);
  problem.load = SphereLoad{tip_A};
  return problem;
}

void contact(Ledger& ledger, const Step& step, double tip_A) {
  ledger.equal("support force / tip force", step.support_force_eV_per_A.z() / step.force_eV_per_A,
               identity(1, "balance of forces"), 1e-8);
  ledger.at_most("penetration / tip radius", step.penetration_A / tip_A, identity(1e-6, "bound set for contact"));
}

/// Where contact ends within an element changes from mesh to mesh: it takes a refinement of 8 to see the
/// order through it.
void finite(Ledger& ledger) {
  for (const char* tip : {"16.5", "27.5"}) {
    const double radius = 10 * std::stod(tip);
    const auto path = [&](int rings) {
      Problem problem = case1(radius, rings);
      problem.levels = {200, 500, 1000};
      return solved(problem);
    };
    const std::vector<Step> coarse = path(18), fine = path(144);
    int level = 0;
    for (const char* depth : {"20", "50", "100"}) {
      ledger.begin(fmt::format("paper's case 1, sphere of {} nm, {} nm deep", tip, depth));
      ledger.converging(
          "force, nN",
          {coarse[level].force_eV_per_A / nN, fine[level].force_eV_per_A / nN, "18 and 144 graded rings", 8},
          tabulated(fmt::format("sphere_{}_nm.force_at_{}_nm", tip, depth)), 2, 0.01);
      contact(ledger, fine[level++], radius);
    }
  }
}

/// Shallow sheet under pretension, contact up to r = b. Stretching adds some E·h d²/(a² N0), 5e-4 here.
void pretension(Ledger& ledger) {
  constexpr double a = 110, N0 = 1, Rt = 100, b = 5;
  const double depth = b * b / Rt * (std::log(a / b) + 0.5);
  Problem problem = round_sheet(a, 8, 0.2, 144);
  problem.prestress_eV_per_A2 = isotropic(N0);
  problem.load = SphereLoad{Rt};
  problem.levels = {depth};
  ledger.begin("pretension alone, contact radius a/22, tip radius a/1.1");
  const Step step = solved_last(problem);
  ledger.equal("F Rt/(2 pi N0 b^2)", step.force_eV_per_A * Rt / (2 * pi * N0 * b * b),
               closed_form(1, "F = 2 pi N0 b^2/Rt at depth (b^2/Rt)(ln(a/b) + 1/2)"), b * b / (Rt * Rt),
               "the law itself leaves out (b/Rt)^2");
  contact(ledger, step, Rt);
}

}  // namespace

void verify_sphere(Ledger& ledger) {
  finite(ledger);
  pretension(ledger);
}

}  // namespace validate::verify

// Sheets that bend: the clamped plate, von Kármán's plate, and on to the membrane at finite strain.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "compare/verify/groups.hpp"
#include "compare/verify/solved.hpp"

namespace validate::verify {
namespace {

using namespace membrane;
using std::numbers::pi;

constexpr double a = 100, nu = 0.3;

Problem bent_sheet(double modulus, double kappa, Load load, int rings) {
  Problem problem = round_sheet(a, modulus, nu, rings);
  problem.relaxed = false;
  problem.bending = clamped_all_round(kappa);
  problem.load = load;
  return problem;
}

/// Small deflection: bending alone. The depth is the centre's.
void plate(Ledger& ledger) {
  constexpr double kappa = 1;
  for (const double c : {0.0, 20.0}) {
    const double compliance =
        c == 0 ? a * a / (16 * pi * kappa) : (4 * a * a - 4 * c * c * std::log(a / c) - 3 * c * c) / (64 * pi * kappa);
    const auto stiffness = [&](int rings) {
      Problem problem = bent_sheet(20, kappa, c == 0 ? Load(PointLoad{}) : Load(DiscLoad{c}), rings);
      problem.levels = {1e-4};
      const Step step = solved_last(problem);
      return step.force_eV_per_A * compliance / step.depth_A;
    };
    ledger.begin(c == 0 ? "clamped plate, point load" : "clamped plate, disc of a/5");
    const std::string formula =
        c == 0 ? "F = 16 pi kappa d/a^2" : "d = F (4 a^2 - 4 c^2 ln(a/c) - 3 c^2)/(64 pi kappa)";
    ledger.equal("F/(stiffness x depth), 72 graded rings", stiffness(72),
                 closed_form(1, formula + ", Timoshenko & Woinowsky-Krieger, ch. 3"), 0.005);
  }
}

/// Bending and stretching share the force. The reference leaves out slopes squared, some (depth/a)².
void von_karman(Ledger& ledger) {
  constexpr double modulus = 20, D = 1e-5;
  Problem problem = bent_sheet(modulus, D * modulus * a * a, DiscLoad{a / 11}, 72);
  problem.law = StVenantKirchhoff{modulus, 0.19};
  problem.control = Control::force;
  problem.levels = {1e-4 * modulus * a};
  ledger.begin("von Karman's plate, kappa = 1e-5 Eh a^2, nu = 0.19, disc of a/11");
  const Step step = solved_last(problem);
  ledger.equal("centre depth/a at F = 1e-4 Eh a", step.depth_A / a, tabulated("plate_depth.D_1e-5.F_1e-4"), 0.003,
               "slopes squared, 1e-3, are left out there");
  const double bent = step.bending_energy_eV / step.energy_eV;
  ledger.at_least("share of bending in the energy", bent, identity(0.1, "neither vanishes"));
  ledger.at_most("share of bending in the energy", bent, identity(0.9, "neither vanishes"));
}

/// The same sheet in one dimension, with other elements and other curvatures.
void finite(Ledger& ledger) {
  constexpr double modulus = 20, kappa = 1, c = 10;
  Problem problem = bent_sheet(modulus, kappa, DiscLoad{c}, 72);
  problem.levels = {2, 8, 20};
  Problem twin = problem;
  twin.discretisation = Meridian{};
  std::vector<Step> twins;
  solve(twin, [&](const Step& step) {
    if (step.converged) twins.push_back(step);
    return step.converged;
  });
  const std::vector<Step> steps = solved(problem);
  if (twins.size() != steps.size()) throw std::runtime_error("the one-dimensional sheet does not reach every level");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ledger.begin(fmt::format("sheet of 100 Å with bending, disc of 10 Å, {:g} Å deep", problem.levels[i]));
    ledger.equal("force, eV/Å", steps[i].force_eV_per_A,
                 identity(twins[i].force_eV_per_A, "the one-dimensional sheet: other elements, other curvatures"),
                 0.003);
    ledger.equal("support force / force", steps[i].support_force_eV_per_A.z() / steps[i].force_eV_per_A,
                 identity(1, "balance of forces"), 1e-6);
  }
}

}  // namespace

void verify_bending(Ledger& ledger) {
  plate(ledger);
  von_karman(ledger);
  finite(ledger);
}

}  // namespace validate::verify

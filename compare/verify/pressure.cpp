// Follower pressure on a clamped disc, and on one whose rim slides.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "compare/verify/groups.hpp"
#include "compare/verify/solved.hpp"

namespace validate::verify {
namespace {

using namespace membrane;

constexpr double a = 110;
constexpr double Eh = 8;

double height(double nu, double load, int rings) {
  Problem problem = round_sheet(a, Eh, nu, rings);
  std::get<DiscSheet>(problem.sheet).spacing = RingSpacing::uniform;
  problem.load = PressureLoad{};
  problem.control = Control::force;
  problem.levels = {load * Eh / a};
  return solved_last(problem).depth_A / a;
}

void hencky(Ledger& ledger) {
  constexpr double load = 1e-6;
  for (const char* nu : {"0.19", "0.3"}) {
    const auto C = [&](int rings) { return height(std::stod(nu), load, rings) / std::cbrt(load); };
    ledger.begin(fmt::format("Hencky, nu = {}, pa/Eh = 1e-6", nu));
    ledger.converging("w0/a (pa/Eh)^(-1/3)", {C(32), C(64), "32 and 64 uniform rings"},
                      tabulated(fmt::format("hencky_C.nu_{}", nu)), 2, 0.01);
  }
}

void finite(Ledger& ledger) {
  for (const char* load : {"1e-3", "1e-2", "1e-1"}) {
    ledger.begin(fmt::format("finite strain, nu = 0.19, pa/Eh = {}", load));
    const auto h = [&](int rings) { return height(0.19, std::stod(load), rings); };
    ledger.converging("w0/a", {h(32), h(64), "32 and 64 uniform rings"},
                      tabulated(fmt::format("svk_pressure_height.nu_0.19.load_{}", load)), 2, 0.01);
  }
}

/// A free rim and nothing that stretches: the sheet of revolution of least area, by the sheet in one
/// dimension (triangles with a free rim leave the round shape). The load is brought down to where strain no
/// longer counts.
void mylar(Ledger& ledger) {
  Problem problem;
  problem.discretisation = Meridian{};
  problem.sheet = DiscSheet{.radius_A = a, .rim = Support::sliding};
  problem.law = StVenantKirchhoff{Eh, 0.3};
  problem.load = PressureLoad{};
  problem.control = Control::force;
  for (const double load : {1.0, 1e-2, 1e-4, 1e-6, 1e-8}) problem.levels.push_back(load * Eh / a);
  Step last;
  const auto report = solve(problem, [&](const Step& step) {
    last = step;
    return true;
  });
  if (!report.converged) throw std::runtime_error("not converged: " + report.reason);
  ledger.begin("Mylar balloon, sheet in one dimension, pa/Eh = 1e-8");
  const char* note = "strain adds 5e-6 here, 8e-5 at pa/Eh = 1e-6; elements half as long change it by 3e-7";
  ledger.equal("w0/a", last.depth_A / a, tabulated("mylar_height"), 1e-5, note);
  ledger.equal("inflated radius/a", 1 + last.on_meridian().back().displacement_A / a, tabulated("mylar_radius"), 1e-5,
               note);
}

}  // namespace

void verify_pressure(Ledger& ledger) {
  hencky(ledger);
  finite(ledger);
  mylar(ledger);
}

}  // namespace validate::verify

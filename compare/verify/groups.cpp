#include "compare/verify/groups.hpp"

#include <array>
#include <exception>

namespace validate::verify {
namespace {

const std::array all = {
    Group{"laws", "derivatives, objectivity, small strain, misprinted equations", verify_laws},
    Group{"patch", "uniform strain, natural width, slack threshold, Hessians of every energy", verify_patch},
    Group{"point", "point load: Schwerin, alpha(nu), beta(nu), uniform and graded meshes", verify_point},
    Group{"disc", "disc load: finite strain, pretension", verify_disc},
    Group{"sphere", "rigid sphere: finite strain, pretension, contact", verify_sphere},
    Group{"bending", "clamped plate, von Karman's plate, on to the membrane at finite strain", verify_bending},
    Group{"pressure", "Hencky, finite strain under follower pressure, Mylar balloon", verify_pressure},
    Group{"wrinkling", "square airbag, strip in bending, annulus in torsion", verify_wrinkling},
    Group{"figure4", "the paper's pressurised square", verify_figure4},
};

const std::array of_wrinkles = {
    Group{"rim", "a disc whose rim slides under a dead tension: taut, tension field, cone", verify_pulled_rim},
};

}  // namespace

std::span<const Group> groups() { return all; }

std::span<const Group> wrinkles_groups() { return of_wrinkles; }

std::vector<VerificationRow> run(const Group& group, const OnRow& on_row) {
  Ledger ledger(std::string(group.name), on_row);
  try {
    group.run(ledger);
  } catch (const std::exception& failure) {
    ledger.equal("converged (1: yes)", 0, identity(1, "every equilibrium is reached"), 0, failure.what());
  }
  return ledger.rows();
}

}  // namespace validate::verify

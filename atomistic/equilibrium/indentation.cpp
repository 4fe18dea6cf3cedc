#include "atomistic/equilibrium/indentation.hpp"

#include <memory>
#include <utility>
#include <variant>

#include "atomistic/equilibrium/path.hpp"
#include "atomistic/equilibrium/shared_sheet.hpp"
#include "atomistic/protocol/preconditioning.hpp"

namespace atomistic {

Box box_around(const Sheet& sheet) {
  const double margin = 5, across = sheet.positions.cwiseAbs().maxCoeff() + margin;
  return {.low = {-across, -across, -torn_depth_of_radius * sheet.radius_A - margin},
          .high = {across, across, sheet.radius_A + margin}};
}

Sheet make_sheet(const Problem& problem) {
  return make_sheet(problem.radius_A, problem.card.a0_A, problem.biaxial_strain, problem.potential.interaction_range_A,
                    problem.form);
}

namespace {

/// Whether the ranks share the sheet, the vectors and the preconditioner, not the forces alone: where the multigrid
/// serves, and nothing is asked for that one rank alone can tell.
bool is_shared(const Problem& problem, const Sheet& sheet, const MpiSession& session) {
  const bool multigrid = preconditioning_for(problem.preconditioning, sheet.free_atoms) == Preconditioning::multigrid;
  const bool of_parts = !std::holds_alternative<PressureLoad>(problem.load) && sheet.built_in_equilibrium() &&
                        !problem.virials && !(problem.ripple_A > 0);
  return session.ranks() > 1 && multigrid && of_parts;
}

/// The whole sheet is given up once it has been shared out.
Report follow_shared_path(const Problem& problem, std::unique_ptr<const Sheet> whole, ForceField& forces,
                          const std::vector<Step>& finished, const PathCallbacks& callbacks,
                          const MpiSession& session) {
  make_load(problem, *whole);  // whether the sheet can take it is seen by the whole
  const SharedSheet shared(*whole, forces);
  whole.reset();
  const PathCallbacks told = session.rank() == 0 ? callbacks : PathCallbacks{};
  return Path(problem, shared, forces, told).follow(finished);
}

}  // namespace

Report follow_path(const Problem& problem, const std::string& log_file, const std::vector<Step>& finished,
                   const PathCallbacks& callbacks, const MpiSession& session) {
  auto whole = std::make_unique<const Sheet>(make_sheet(problem));
  const Sheet& sheet = *whole;
  ForceField forces(problem.potential, box_around(sheet), sheet.positions, log_file);
  if (is_shared(problem, sheet, session))
    return follow_shared_path(problem, std::move(whole), forces, finished, callbacks, session);
  if (session.rank() != 0) {
    forces.serve();
    return {};
  }
  return Path(problem, sheet, forces, callbacks).follow(finished);
}

}  // namespace atomistic

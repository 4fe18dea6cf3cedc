#include "atomistic/equilibrium/indentation.hpp"

#include "atomistic/equilibrium/path.hpp"

namespace atomistic {
namespace {

Box box_around(const Sheet& sheet) {
  const double margin = 5, across = sheet.positions.cwiseAbs().maxCoeff() + margin;
  return {.low = {-across, -across, -torn_depth_of_radius * sheet.radius_A - margin},
          .high = {across, across, sheet.radius_A + margin}};
}

}  // namespace

Sheet make_sheet(const Problem& problem) {
  return make_sheet(problem.radius_A, problem.card.a0_A, problem.biaxial_strain, problem.potential.interaction_range_A,
                    problem.form);
}

Report follow_path(const Problem& problem, const std::string& log_file, const std::vector<Step>& finished,
                   const PathCallbacks& callbacks, const MpiSession& session) {
  const Sheet sheet = make_sheet(problem);
  ForceField forces(problem.potential, box_around(sheet), sheet.positions, log_file);
  if (session.rank() != 0) {
    forces.serve();
    return {};
  }
  return Path(problem, sheet, forces, callbacks).follow(finished);
}

}  // namespace atomistic

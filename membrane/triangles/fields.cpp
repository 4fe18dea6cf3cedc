#include "membrane/triangles/fields.hpp"

#include <cmath>

#include "membrane/laws/cauchy.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/triangles/model.hpp"

namespace membrane {
namespace {

/// The angle of a principal direction from its doubled one.
double angle_of(const Principal& at) { return 0.5 * std::atan2(at.sin_2theta, at.cos_2theta); }

/// Adds the triangle's values; returns its state.
template <MaterialLaw L>
SheetState add_triangle(const L& law, const Material& material, const Voigt& strain, SheetFields& fields) {
  const Voigt& offset = material.offset_strain;
  const SheetState state = material.relaxed ? sheet_state(law, Voigt(strain + offset)) : SheetState::taut;
  const Principal force = principal_forces(membrane_force(material, strain));
  const Principal cauchy = principal_forces(cauchy_force(law, strain, offset, material.relaxed));
  fields.state.push_back(state);
  fields.strain.push_back(strain);
  fields.force_1_eV_per_A2.push_back(force.larger);
  fields.force_2_eV_per_A2.push_back(force.smaller);
  fields.direction_rad.push_back(angle_of(force));
  fields.cauchy_1_eV_per_A2.push_back(cauchy.larger);
  fields.cauchy_2_eV_per_A2.push_back(cauchy.smaller);
  return state;
}

}  // namespace

SheetFields fields_of(const Problem& problem, const Mesh& mesh, const Eigen::VectorXd& displacements) {
  const Material material = material_of(problem, mesh);
  SheetFields fields;
  double wrinkled = 0, slack = 0;
  std::visit(
      [&]<MaterialLaw L>(const L& law) {
        for (const Triangle& triangle : mesh.triangles) {
          const SheetState state = add_triangle(law, material, strain_of(triangle, displacements), fields);
          if (state == SheetState::wrinkled) wrinkled += triangle.area_A2;
          if (state == SheetState::slack) slack += triangle.area_A2;
        }
      },
      problem.law);
  fields.wrinkled_area_fraction = wrinkled / mesh.area_A2();
  fields.slack_area_fraction = slack / mesh.area_A2();
  return fields;
}

}  // namespace membrane

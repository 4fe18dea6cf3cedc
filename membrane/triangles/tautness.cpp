#include "membrane/triangles/tautness.hpp"

#include <algorithm>
#include <limits>

#include "membrane/laws/principal.hpp"
#include "membrane/laws/tension_field.hpp"

namespace membrane {

Tautness tautness_of(const Mesh& mesh, const Material& material, const Eigen::VectorXd& u) {
  Tautness found;
  found.least_force_eV_per_A2 = std::numeric_limits<double>::infinity();
  const double rounding = least_compression(material.law);
  std::visit(
      [&]<MaterialLaw L>(const L& law) {
        for (const Triangle& triangle : mesh.triangles) {
          const Voigt strain = strain_of(triangle, u);
          const double force = principal_forces(membrane_force(material, strain)).smaller;
          found.least_force_eV_per_A2 = std::min(found.least_force_eV_per_A2, force);
          if (force < -rounding) found.compressed_area_fraction += triangle.area_A2;
          if (!material.relaxed) continue;
          const SheetState state = sheet_state(law, Voigt(strain + material.offset_strain));
          if (state == SheetState::wrinkled) found.wrinkled_area_fraction += triangle.area_A2;
          if (state == SheetState::slack) found.slack_area_fraction += triangle.area_A2;
        }
      },
      material.law);
  const double area = mesh.area_A2();
  for (double* share : {&found.wrinkled_area_fraction, &found.slack_area_fraction, &found.compressed_area_fraction})
    *share /= area;
  return found;
}

double mean_outward_on_rim(const Mesh& mesh, const Eigen::VectorXd& u) {
  if (mesh.rings.empty()) return 0;
  const NodeRing& rim = mesh.rings.back();
  double sum = 0, count = 0;
  for (int k = 0; k < rim.count; ++k) {
    const int node = rim.first + k;
    const double weight = !rim.closed && (k == 0 || k + 1 == rim.count) ? 0.5 : 1;
    sum += weight * u.segment<2>(3 * node).dot(mesh.nodes[node].normalized());
    count += weight;
  }
  return sum / count;
}

}  // namespace membrane

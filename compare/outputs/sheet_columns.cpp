#include "compare/outputs/sheet_columns.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace compare {
namespace {

std::vector<double> over(std::vector<double> values, double divisor) {
  for (double& value : values) value /= divisor;
  return values;
}

std::vector<double> copy(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

std::vector<SheetColumn> triangle_columns(const membrane::SheetFields& fields, double thickness_A) {
  SheetColumn state{"state", "", "0 taut, 1 wrinkled, 2 slack", 1, {}};
  SheetColumn strain{"strain", "", "Green-Lagrange strain E11, E22, E12", 3, {}};
  SheetColumn direction{"direction", "", "unit vector of the larger membrane force in the flat sheet: along the wrinkles",
                        3, {}};
  for (std::size_t t = 0; t < fields.state.size(); ++t) {
    state.values.push_back(static_cast<double>(fields.state[t]));
    strain.values.insert(strain.values.end(), {fields.strain[t][0], fields.strain[t][1], 0.5 * fields.strain[t][2]});
    direction.values.insert(direction.values.end(),
                            {std::cos(fields.direction_rad[t]), std::sin(fields.direction_rad[t]), 0});
  }
  return {state,
          strain,
          {"force_1_eV_per_A2", "eV/Å²", "larger principal membrane force (second Piola-Kirchhoff)", 1,
           fields.force_1_eV_per_A2},
          {"force_2_eV_per_A2", "eV/Å²", "smaller principal membrane force", 1, fields.force_2_eV_per_A2},
          direction,
          {"cauchy_1_eV_per_A3", "eV/Å³", "larger principal Cauchy stress, plane-stress thickness, natural width", 1,
           over(fields.cauchy_1_eV_per_A2, thickness_A)},
          {"cauchy_2_eV_per_A3", "eV/Å³", "smaller principal Cauchy stress", 1,
           over(fields.cauchy_2_eV_per_A2, thickness_A)}};
}

}  // namespace

SheetPicture picture_of(const membrane::Problem& problem, const membrane::Step& step, double thickness_A) {
  SheetPicture picture;
  picture.mesh = membrane::mesh_of(problem);
  picture.triangles = triangle_columns(membrane::fields_of(problem, picture.mesh, step), thickness_A);
  picture.displacement = copy(step.displacements);
  picture.nodes = {{"displacement_A", "Å", "displacement from the flat sheet", 3, picture.displacement},
                   {"reaction_eV_per_A", "eV/Å", "force of the supports and symmetry planes on the node", 3,
                    copy(step.reactions)}};
  picture.level = problem.levels[step.level];
  return picture;
}

const std::vector<double>& column(const std::vector<SheetColumn>& columns, const std::string& key) {
  const auto at = std::find_if(columns.begin(), columns.end(), [&](const SheetColumn& c) { return c.key == key; });
  if (at == columns.end()) throw std::out_of_range("no column " + key);
  return at->values;
}

}  // namespace compare

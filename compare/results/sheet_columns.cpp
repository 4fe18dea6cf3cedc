#include "compare/results/sheet_columns.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace validate {
namespace {

std::vector<double> over(std::vector<double> values, double divisor) {
  for (double& value : values) value /= divisor;
  return values;
}

std::vector<double> copy(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

std::vector<SheetColumn> triangle_columns(const membrane::SheetFields& fields, double thickness_A) {
  SheetColumn state{"state", "", "0 taut, 1 wrinkled, 2 slack", 1, {}};
  SheetColumn strain{"strain", "", "Green-Lagrange strain E11, E22, E12", 3, {}};
  SheetColumn direction{
      "direction", "", "unit vector of the larger membrane force in the flat sheet: along the wrinkles", 3, {}};
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

std::vector<SheetTotal> totals_of(const membrane::SheetFields& fields, const membrane::Step& step) {
  return {{"depth_A", "Å", "depth of record", step.depth_A},
          {"conjugate_depth_A", "Å", "depth conjugate to the force", step.conjugate_depth_A},
          {"force_eV_per_A", "eV/Å", "force of the tip on the sheet", step.force_eV_per_A},
          {"pressure_eV_per_A3", "eV/Å³", "follower pressure towards -z", step.pressure_eV_per_A3},
          {"support_force_z_eV_per_A", "eV/Å", "force of the supports on the sheet, z component",
           step.support_force_eV_per_A.z()},
          {"volume_A3", "Å³", "volume between the sheet and its plane", step.volume_A3},
          {"energy_eV", "eV", "relaxed energy relative to the flat sheet", step.energy_eV},
          {"wrinkled_area_fraction", "", "share of the area in uniaxial tension", fields.wrinkled_area_fraction},
          {"slack_area_fraction", "", "share of the area without tension", fields.slack_area_fraction},
          {"relative_residual", "", "residual over the load", step.relative_residual}};
}

template <class Named>
const Named& find(const std::vector<Named>& list, const std::string& key) {
  const auto at = std::find_if(list.begin(), list.end(), [&](const Named& n) { return n.key == key; });
  if (at == list.end()) throw std::out_of_range("no field " + key);
  return *at;
}

}  // namespace

SheetPicture picture_of(const membrane::Problem& problem, const membrane::Step& step, double thickness_A) {
  SheetPicture picture;
  picture.mesh = membrane::mesh_of(problem);
  const membrane::SheetFields fields = membrane::fields_of(problem, picture.mesh, step.on_triangles().displacements);
  picture.triangles = triangle_columns(fields, thickness_A);
  picture.totals = totals_of(fields, step);
  picture.thickness_A = thickness_A;
  picture.displacement = copy(step.on_triangles().displacements);
  picture.nodes = {{"displacement_A", "Å", "displacement from the flat sheet", 3, picture.displacement},
                   {"reaction_eV_per_A", "eV/Å", "force of the supports and symmetry planes on the node", 3,
                    copy(step.on_triangles().reactions)}};
  picture.level = problem.levels[step.level];
  return picture;
}

SheetShape shape_of(const SheetPicture& picture) {
  const auto single = [](const std::vector<double>& values) {
    return std::vector<float>(values.begin(), values.end());
  };
  return {.depth_A = total(picture.totals, "depth_A"),
          .force_eV_per_A = total(picture.totals, "force_eV_per_A"),
          .displacement_A = single(picture.displacement),
          .cauchy_1_eV_per_A3 = single(column(picture.triangles, "cauchy_1_eV_per_A3")),
          .state = single(column(picture.triangles, "state"))};
}

void SheetAlbum::keep(const membrane::Step& step) {
  if (step.converged) steps_.push_back(step);
}

std::vector<SheetPicture> SheetAlbum::pictures() const {
  std::vector<SheetPicture> pictures;
  std::vector<SheetShape> earlier;
  for (const membrane::Step& step : steps_) {
    pictures.push_back(picture_of(problem_, step, thickness_A_));
    if (every_level_ || &step == &steps_.back()) continue;
    earlier.push_back(shape_of(pictures.back()));
    pictures.clear();
  }
  if (!pictures.empty()) pictures.back().earlier = std::move(earlier);
  return pictures;
}

double total(const std::vector<SheetTotal>& totals, const std::string& key) { return find(totals, key).value; }

const std::vector<double>& column(const std::vector<SheetColumn>& columns, const std::string& key) {
  return find(columns, key).values;
}

}  // namespace validate

#include "compare/study/bulge_atoms.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "compare/pairing/pairing.hpp"
#include "compare/study/curves.hpp"

namespace validate {
namespace {

Profile sorted(const Profile& profile) {
  std::vector<std::size_t> order(profile.x_A.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return profile.x_A[i]; });
  Profile result;
  for (const std::size_t i : order) {
    result.x_A.push_back(profile.x_A[i]);
    result.z_A.push_back(profile.z_A[i]);
  }
  return result;
}

BulgeAtomsPoint point_of(const atomistic::Step& step, double area_A2, double artefact_from_A) {
  return {.pressure_eV_per_A3 = step.target,
          .depth_A = step.depth_A,
          .volume_A3 = step.conjugate_depth_A * area_A2,
          .energy_eV = step.energy_eV,
          .converged = step.converged,
          .artefact = step.longest_bond_A >= artefact_from_A,
          .longest_bond_A = step.longest_bond_A,
          .max_force_eV_per_A = step.max_force_eV_per_A,
          .balance_relative = step.balance_relative,
          .force_evaluations = step.evaluations,
          .factorisations = step.factorisations};
}

}  // namespace

Profile profile_of(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions) {
  constexpr double half_width_bonds = 0.6;
  Profile profile;
  for (int i = 0; i < sheet.free_atoms; ++i) {
    if (std::abs(sheet.position(i).y()) > half_width_bonds * sheet.bond_A) continue;
    profile.x_A.push_back(positions[3 * i]);
    profile.z_A.push_back(positions[3 * i + 2]);
  }
  return sorted(profile);
}

Profile profile_of(const SheetPicture& picture) {
  const membrane::Mesh& mesh = picture.mesh;
  Profile profile;
  double size = 0;
  for (const Eigen::Vector2d& node : mesh.nodes) size = std::max(size, node.norm());
  for (int n = 0; n < mesh.node_count(); ++n) {
    if (std::abs(mesh.nodes[static_cast<std::size_t>(n)].y()) > 1e-9 * size) continue;
    const double x =
        mesh.nodes[static_cast<std::size_t>(n)].x() + picture.displacement[3 * static_cast<std::size_t>(n)];
    const double z = picture.displacement[3 * static_cast<std::size_t>(n) + 2];
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && (mesh.copies == 1 || x < 1e-9 * size)) continue;
      profile.x_A.push_back(side * x);
      profile.z_A.push_back(z);
    }
  }
  return sorted(profile);
}

namespace {

/// Of the calibrated sheet, as far as it goes.
std::vector<double> sheet_depths(const BulgePair& pair) {
  std::vector<double> depths;
  if (!pair.calibrated) return depths;
  membrane::axisymmetric::solve(*pair.calibrated, [&](const membrane::axisymmetric::SheetStep& step) {
    if (step.converged) depths.push_back(step.depth_A);
    return step.converged;
  });
  return depths;
}

}  // namespace

BulgeAtoms bulge_atoms(const BulgePair& pair, const AtomsCurve& curve, const std::vector<double>& membrane_depth_A,
                       const std::vector<SheetPicture>& pictures) {
  BulgeAtoms result;
  result.card = summary_of(pair.atoms.card, pair.atoms.potential.artefact_bond_A);
  result.atoms = pair.sheet.atoms();
  result.free_atoms = pair.sheet.free_atoms;
  result.membrane_size_x_A = pair.size_A.x();
  result.membrane_size_y_A = pair.size_A.y();
  const std::vector<double> sheet = sheet_depths(pair);
  for (std::size_t i = 0; i < curve.steps.size(); ++i) {
    const atomistic::Step& step = curve.steps[i];
    const double area = step.force_eV_per_A / step.target;  // force = pressure × flat area
    BulgeAtomsPoint point = point_of(step, area, pair.atoms.potential.artefact_bond_A);
    if (i < membrane_depth_A.size()) {
      point.membrane_depth_A = membrane_depth_A[i];
      point.depth_ratio = point.depth_A / point.membrane_depth_A;
      result.atoms_profile = profile_of(pair.sheet, step.positions);
      result.membrane_profile = profile_of(pictures[i]);
    }
    if (i < sheet.size()) {
      point.sheet_depth_A = sheet[i];
      point.sheet_ratio = point.depth_A / sheet[i];
    }
    result.points.push_back(point);
  }
  if (curve.report) {
    Run ended;
    close(ended, *curve.report);
    result.ended = ended.ended;
    result.ended_reason = ended.ended_reason;
  } else {
    result.ended_reason = curve.failure;
  }
  return result;
}

}  // namespace validate

// A clamped edge that is moved.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "membrane/loads/setting.hpp"

namespace membrane {

/// A clamped edge moves as a rigid body: levels are multiples of this motion.
struct EdgeMotion {
  Edge edge = Edge::hub;
  Eigen::Vector3d translation_A = Eigen::Vector3d::Zero();
  Eigen::Vector2d pivot_A = Eigen::Vector2d::Zero();  ///< of the rotation about the z axis
  double rotation_rad = 0;

  void check(const LoadSetting& setting) const {
    const auto supports = supports_of(setting.sheet);
    const auto at = std::find_if(supports.begin(), supports.end(), [&](const auto& s) { return s.first == edge; });
    if (at == supports.end()) refuse("load.edge", int(edge), "the meshed part of the sheet has no such edge");
    if (at->second != Support::clamped) refuse("load.edge", int(edge), "the edge that moves must be clamped");
    if (!translation_A.allFinite() || !pivot_A.allFinite() || !std::isfinite(rotation_rad))
      refuse("load.translation_A", translation_A.transpose(), "the motion must be finite");
    if (translation_A.norm() + std::abs(rotation_rad) == 0)
      refuse("load.translation_A", 0, "the edge does not move: give a translation or a rotation");
    check_corners(setting.sheet);
    if (setting.control != Control::conjugate_depth)
      refuse("control", "force", "a motion is prescribed: control must be conjugate_depth");
    if (setting.pressure_eV_per_A3 != 0)
      refuse("pressure_eV_per_A3", setting.pressure_eV_per_A3, "must be 0 where an edge moves");
  }

  /// The solvers that can move an edge take the motion as it is.
  const EdgeMotion& action() const { return *this; }

  /// Nothing pulls the sheet out of its plane.
  bool in_plane() const { return translation_A.z() == 0; }

 private:
  /// Edges that end in each other's corners.
  static bool meet(Edge a, Edge b) {
    const auto upright = [](Edge e) { return e == Edge::left || e == Edge::right; };
    const auto lying = [](Edge e) { return e == Edge::bottom || e == Edge::top; };
    return (upright(a) && lying(b)) || (lying(a) && upright(b));
  }

  /// A node cannot move with one edge and stay with another, or in a symmetry plane that the motion leaves.
  void check_corners(const Sheet& sheet) const {
    const bool turns = rotation_rad != 0;
    const bool leaves_centre = turns || translation_A.head<2>().norm() > 0;
    for (const auto& [other, support] : supports_of(sheet))
      if (meet(other, edge) && (support == Support::clamped || (support == Support::sliding && !in_plane())))
        refuse("load.edge", int(edge), "it meets an edge that stays: its corner cannot do both; let that edge be free");
    const auto* disc = std::get_if<DiscSheet>(&sheet);
    if (disc && disc->extent == Extent::quarter && leaves_centre)
      refuse("load.translation_A", translation_A.transpose(),
             "a quarter's rim moves out of its symmetry planes: mesh the full sheet");
    const auto* rectangle = std::get_if<RectangleSheet>(&sheet);
    if (!rectangle || rectangle->extent == Extent::full) return;
    const double along = edge == Edge::right ? translation_A.y() : translation_A.x();
    if (turns || along != 0)
      refuse("load.translation_A", translation_A.transpose(),
             "a quarter's edge moves out of its symmetry plane: mesh the full sheet");
  }
};

}  // namespace membrane

// What a pressure is conjugate to: the volume under a sheet over the sheet's area.
#pragma once

#include "membrane/triangles/model.hpp"
#include "membrane/triangles/newton.hpp"

namespace membrane {

/// D = volume / area on the side of −z; its force is pressure times area, so that −F D is the pressure's
/// energy.
class MeanDepth final : public CurvedDepth {
 public:
  explicit MeanDepth(Model& model) : model_(model), area_(model.mesh().area_A2()) {}

  double of(const Eigen::VectorXd& u) const { return -model_.pressure().volume(u) / area_; }

  double force() const override { return model_.pressure_towards_tip() * area_; }
  void set_force(double force_eV_per_A) override { model_.set_pressure(force_eV_per_A / area_); }
  Eigen::VectorXd direction(const Eigen::VectorXd& u) const override {
    return -model_.pressure().volume_gradient(u) / area_;
  }
  /// The volume over the plane z = 0 is linear in the heights: they are scaled. u must have a volume.
  void restore(double depth_A, Eigen::VectorXd& u) const override {
    const Eigen::Index nodes = model_.mesh().node_count();
    u.head(3 * nodes).reshaped(3, nodes).row(2) *= depth_A / of(u);
  }

 private:
  Model& model_;
  double area_;
};

}  // namespace membrane

// The stretching energy of a sheet: a law over constant-strain triangles.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "membrane/laws/list.hpp"
#include "membrane/sheets/mesh.hpp"
#include "membrane/terms/term.hpp"

namespace membrane {

/// What the triangles are made of.
struct Material {
  Law law;
  Voigt offset_strain = Voigt::Zero();  ///< the prestress, see laws/prestress.hpp
  bool relaxed = true;                  ///< tension-field energy
};

/// Energy relative to the flat prestressed sheet, of the meshed part, not of its copies. Keeps a reference to the mesh.
/// The negative curvature it may leave out is what compressive membrane forces take (∇N_a · S ∇N_b with S < 0): without
/// it the Hessian is positive semi-definite for any law that is convex in strain. The relaxed laws have none.
class Stretching final : public EnergyTerm {
 public:
  Stretching(const Mesh& mesh, Material material);

  void couple(NodePairs& pairs) const override;
  void locate(const Hessian& hessian) override;
  double add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) override;
  void add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) override;

  double part_norm() const override { return part_norm_; }
  double counted_from() const override { return std::abs(flat_energy_density_) * mesh_.area_A2(); }

  const Material& material() const { return material_; }
  void set_material(Material material);

 private:
  const Mesh& mesh_;
  Material material_;
  double flat_energy_density_ = 0;
  double part_norm_ = 0;
  std::vector<std::array<Hessian::Place, 3>> places_;  ///< per triangle: node pairs (1, 0), (2, 0), (2, 1)
};

/// Membrane force (second Piola–Kirchhoff × thickness, eV/Å²) at a strain.
Voigt membrane_force(const Material& material, const Voigt& strain);

/// Strain of one triangle under displacements u.
Voigt strain_of(const Triangle& triangle, const Eigen::VectorXd& u);

}  // namespace membrane

#include "membrane/terms/stretching.hpp"

#include <cmath>
#include <utility>

#include "membrane/laws/principal.hpp"
#include "membrane/laws/tension_field.hpp"
#include "membrane/terms/kinematics.hpp"

namespace membrane {
namespace {

/// Calls visit(response) with the call E -> Response of the material: the law is looked up once per pass over
/// the sheet, not once per triangle.
template <class Visit>
auto with_response(const Material& material, Visit visit) {
  const Voigt& offset = material.offset_strain;
  return std::visit(
      [&]<MaterialLaw L>(const L& law) {
        if (material.relaxed)
          return visit([&](const Voigt& strain) { return tension_field(law, Voigt(strain + offset)); });
        return visit([&](const Voigt& strain) { return law(Voigt(strain + offset)); });
      },
      material.law);
}

NodeVectors displacements_of(const Triangle& triangle, const Eigen::VectorXd& u) {
  NodeVectors displacements;
  for (int a = 0; a < 3; ++a) displacements.col(a) = u.segment<3>(3 * triangle.nodes[a]);
  return displacements;
}

constexpr std::array<std::array<int, 2>, 3> corner_pairs = {{{1, 0}, {2, 0}, {2, 1}}};

}  // namespace

Stretching::Stretching(const Mesh& mesh, Material material) : mesh_(mesh) { set_material(std::move(material)); }

void Stretching::set_material(Material material) {
  material_ = std::move(material);
  flat_energy_density_ =
      with_response(material_, [](const auto& response) { return response(Voigt::Zero()).energy_eV_per_A2; });
}

void Stretching::couple(NodePairs& pairs) const {
  for (const Triangle& triangle : mesh_.triangles)
    for (const auto& [a, b] : corner_pairs) pairs.emplace_back(triangle.nodes[a], triangle.nodes[b]);
}

void Stretching::locate(const Hessian& hessian) {
  places_.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < places_.size(); ++t)
    for (int pair = 0; pair < 3; ++pair) {
      const auto& [a, b] = corner_pairs[pair];
      places_[t][pair] = hessian.place(mesh_.triangles[t].nodes[a], mesh_.triangles[t].nodes[b]);
    }
}

double Stretching::add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  return with_response(material_, [&](const auto& response) {
    double energy = 0;
    double parts = 0;
    for (const Triangle& triangle : mesh_.triangles) {
      const Deformation deformation(triangle, displacements_of(triangle, u));
      const Response at = response(deformation.green_lagrange());
      energy += triangle.area_A2 * (at.energy_eV_per_A2 - flat_energy_density_);
      const NodeVectors forces = node_forces(triangle, deformation, at.force_eV_per_A2);
      parts += forces.squaredNorm();
      for (int a = 0; a < 3; ++a) gradient.segment<3>(3 * triangle.nodes[a]) += forces.col(a);
    }
    part_norm_ = std::sqrt(parts);
    return energy;
  });
}

void Stretching::add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) {
  with_response(material_, [&](const auto& response) {
    TriangleStiffness k;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& triangle = mesh_.triangles[t];
      const auto& nodes = triangle.nodes;
      const Deformation deformation(triangle, displacements_of(triangle, u));
      Response at = response(deformation.green_lagrange());
      if (share > 0) at.force_eV_per_A2 += share * (tensile_part(at.force_eV_per_A2) - at.force_eV_per_A2);
      stiffness(triangle, deformation, at, k);
      Eigen::Matrix3d block;
      for (int a = 0; a < 3; ++a) {
        block = k.block<3, 3>(3 * a, 3 * a);
        release_held(mesh_.held[nodes[a]], mesh_.held[nodes[a]], block);
        hessian.add_diagonal(nodes[a], block);
      }
      for (int pair = 0; pair < 3; ++pair) {
        const auto& [a, b] = corner_pairs[pair];
        block = k.block<3, 3>(3 * a, 3 * b);
        release_held(mesh_.held[nodes[a]], mesh_.held[nodes[b]], block);
        hessian.add(places_[t][pair], block);
      }
    }
  });
}

Voigt membrane_force(const Material& material, const Voigt& strain) {
  return with_response(material, [&](const auto& response) { return response(strain).force_eV_per_A2; });
}

Voigt strain_of(const Triangle& triangle, const Eigen::VectorXd& u) {
  return Deformation(triangle, displacements_of(triangle, u)).green_lagrange();
}

}  // namespace membrane

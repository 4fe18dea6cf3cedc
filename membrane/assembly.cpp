#include "membrane/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "membrane/kinematics.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/laws/tension_field.hpp"

namespace membrane {
namespace {

/// Calls visit(response) with the call E -> Response of the material: the law is looked up once per pass over
/// the sheet, not once per triangle.
template <class Visit>
auto with_response(const Material& material, Visit visit) {
  const Voigt& offset = material.offset_strain;
  return std::visit(
      [&](const auto& law) {
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

bool is_held(const Mesh& mesh, int dof) { return mesh.held[dof / 3][dof % 3]; }

int dof_of(const Triangle& triangle, int local) { return 3 * triangle.nodes[local / 3] + local % 3; }

/// Calls visit(local row, local column, k) over the lower half of a triangle's stiffness.
template <class Visit>
void over_lower_half(Visit visit) {
  int k = 0;
  for (int column = 0; column < 9; ++column)
    for (int row = column; row < 9; ++row) visit(row, column, k++);
}

}  // namespace

Assembly::Assembly(const Mesh& mesh, Material material) : mesh_(mesh), material_(std::move(material)) {
  flat_energy_density_ =
      with_response(material_, [](const auto& response) { return response(Voigt::Zero()).energy_eV_per_A2; });
  build_pattern();
}

void Assembly::build_pattern() {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(45 * mesh_.triangles.size());
  for (int dof = 0; dof < mesh_.dof_count(); ++dof) entries.emplace_back(dof, dof, 0);
  const auto global = [&](const Triangle& triangle, int row, int column) {
    return std::minmax({dof_of(triangle, row), dof_of(triangle, column)});  // column, row
  };
  const auto is_free = [&](const std::pair<int, int>& place) {
    return !is_held(mesh_, place.first) && !is_held(mesh_, place.second);
  };
  for (const Triangle& triangle : mesh_.triangles)
    over_lower_half([&](int row, int column, int) {
      const auto place = global(triangle, row, column);
      if (is_free(place)) entries.emplace_back(place.second, place.first, 0);
    });
  hessian_.resize(mesh_.dof_count(), mesh_.dof_count());
  hessian_.setFromTriplets(entries.begin(), entries.end());

  const auto find = [&](int row, int column) {
    const int* const begin = hessian_.innerIndexPtr() + hessian_.outerIndexPtr()[column];
    const int* const end = hessian_.innerIndexPtr() + hessian_.outerIndexPtr()[column + 1];
    return static_cast<int>(std::lower_bound(begin, end, row) - hessian_.innerIndexPtr());
  };
  places_.reserve(mesh_.triangles.size());
  for (const Triangle& triangle : mesh_.triangles) {
    auto& places = places_.emplace_back();
    over_lower_half([&](int row, int column, int k) {
      const auto place = global(triangle, row, column);
      places[k] = is_free(place) ? find(place.second, place.first) : -1;
    });
  }
  for (int dof = 0; dof < mesh_.dof_count(); ++dof)
    if (is_held(mesh_, dof)) held_diagonal_.push_back(find(dof, dof));
}

double Assembly::energy(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  ++passes_;
  gradient.setZero(mesh_.dof_count());
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

template <class Edit>
const Assembly::Matrix& Assembly::assemble(const Eigen::VectorXd& u, Edit edit) {
  ++passes_;
  double* const values = hessian_.valuePtr();
  std::fill_n(values, hessian_.nonZeros(), 0.0);
  for (int place : held_diagonal_) values[place] = 1;
  with_response(material_, [&](const auto& response) {
    TriangleStiffness k;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& triangle = mesh_.triangles[t];
      const Deformation deformation(triangle, displacements_of(triangle, u));
      Response at = response(deformation.green_lagrange());
      edit(at);
      stiffness(triangle, deformation, at, k);
      const auto& places = places_[t];
      over_lower_half([&](int row, int column, int entry) {
        if (places[entry] >= 0) values[places[entry]] += k(row, column);
      });
    }
  });
  return hessian_;
}

const Assembly::Matrix& Assembly::hessian(const Eigen::VectorXd& u) {
  return assemble(u, [](Response&) {});
}

const Assembly::Matrix& Assembly::convex_hessian(const Eigen::VectorXd& u, double share) {
  return assemble(u, [share](Response& at) {
    at.force_eV_per_A2 += share * (tensile_part(at.force_eV_per_A2) - at.force_eV_per_A2);
  });
}

Voigt Assembly::membrane_force(const Eigen::VectorXd& u, int triangle) const {
  const Triangle& at = mesh_.triangles[triangle];
  const Deformation deformation(at, displacements_of(at, u));
  return with_response(material_, [&](const auto& response) {
    return response(deformation.green_lagrange()).force_eV_per_A2;
  });
}

}  // namespace membrane

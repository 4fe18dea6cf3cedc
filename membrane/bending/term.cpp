#include "membrane/bending/term.hpp"

#include <algorithm>
#include <cmath>

namespace membrane {
namespace {

/// Forces rounded in a sum lose some hundred times 1e-16 of their parts; an angle's own cancellation loses
/// 1e-16 once.
constexpr double shown_cancellation = 0.01;

std::vector<std::array<int, 3>> corners_of(const Mesh& mesh) {
  std::vector<std::array<int, 3>> corners;
  for (const Triangle& triangle : mesh.triangles) corners.push_back(triangle.nodes);
  return corners;
}

/// Whether both nodes lie on the symmetry plane x = 0 (component 0) or y = 0, or are held altogether.
SlopeSupport support_of(const Mesh& mesh, int a, int b) {
  for (int component : {0, 1})
    if (mesh.mirrored[component] && mesh.nodes[a][component] == 0 && mesh.nodes[b][component] == 0)
      return SlopeSupport::held;
  const auto clamped = [&](int node) { return mesh.held[node][0] && mesh.held[node][1] && mesh.held[node][2]; };
  return clamped(a) && clamped(b) ? SlopeSupport::held : SlopeSupport::free;
}

Bending bending_of(const Mesh& mesh, BendingModuli moduli) {
  return {mesh.nodes, corners_of(mesh), moduli, [&](int a, int b) { return support_of(mesh, a, b); }};
}

int slot_of(std::vector<int>& nodes, int node) {
  const auto at = std::find(nodes.begin(), nodes.end(), node);
  if (at != nodes.end()) return static_cast<int>(at - nodes.begin());
  nodes.push_back(node);
  return static_cast<int>(nodes.size()) - 1;
}

}  // namespace

BendingTerm::BendingTerm(const Mesh& mesh, BendingModuli moduli, int first_node)
    : held_(mesh.held),
      bending_(bending_of(mesh, moduli)),
      first_node_(first_node),
      lever_A_(bending_.rotation_count()) {
  for (int r = 0; r < bending_.rotation_count(); ++r) {
    const auto [a, b] = bending_.ends(r);
    lever_A_[r] = (mesh.nodes[b] - mesh.nodes[a]).norm() / 2;
  }
}

Held BendingTerm::held_rotations() const {
  Held held(additional_nodes(), {true, true, true});
  for (int r = 0; r < bending_.rotation_count(); ++r) held[r / 3][r % 3] = bending_.rotation_is_held(r);
  return held;
}

Eigen::VectorXd BendingTerm::rotations(const Eigen::VectorXd& u) const {
  return u.segment(3 * first_node_, bending_.rotation_count()).cwiseQuotient(lever_A_);
}

double BendingTerm::add_gradient(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  part_norm_ = shown_cancellation * bending_.uncancelled(u);
  Eigen::VectorXd by_rotations = Eigen::VectorXd::Zero(bending_.rotation_count());
  const double energy = bending_.add_gradient(u, rotations(u), gradient, by_rotations);
  gradient.segment(3 * first_node_, bending_.rotation_count()) += by_rotations.cwiseQuotient(lever_A_);
  return energy;
}

BendingTerm::Blocks BendingTerm::blocks(const Bending::Part& part) const {
  Blocks blocks;
  std::vector<int> place;     // of each row of the part
  std::vector<double> scale;  // dα/du; 0 where held
  for (int node : part.nodes) {
    const int slot = slot_of(blocks.nodes, node);
    for (int c = 0; c < 3; ++c) {
      place.push_back(3 * slot + c);
      scale.push_back(held_[node][c] ? 0 : 1);
    }
  }
  for (int r : part.rotations) {
    place.push_back(3 * slot_of(blocks.nodes, first_node_ + r / 3) + r % 3);
    scale.push_back(1 / lever_A_[r]);
  }
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(blocks.nodes.size());
  blocks.k = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < part.k.rows(); ++i)
    for (Eigen::Index j = 0; j < part.k.cols(); ++j) blocks.k(place[i], place[j]) = scale[i] * scale[j] * part.k(i, j);
  return blocks;
}

/// Of every part, in the order of over_hessian().
std::vector<std::vector<int>> BendingTerm::coupled_nodes() const {
  std::vector<std::vector<int>> nodes;
  const Bending::Visit note = [&](const Bending::Part& part) { nodes.push_back(blocks(part).nodes); };
  bending_.over_hessian(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(held_.size())),
                        Eigen::VectorXd::Zero(bending_.rotation_count()), note, note);
  return nodes;
}

void BendingTerm::couple(NodePairs& pairs) const {
  for (const auto& nodes : coupled_nodes())
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) pairs.emplace_back(nodes[i], nodes[j]);
}

void BendingTerm::locate(const Hessian& hessian) {
  places_.clear();
  for (const auto& nodes : coupled_nodes())
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) places_.push_back(hessian.place(nodes[i], nodes[j]));
}

void BendingTerm::add_hessian(const Eigen::VectorXd& u, double share, Hessian& hessian) {
  auto place = places_.begin();
  const auto add = [&](const Bending::Part& part, double factor) {
    const Blocks at = blocks(part);
    for (std::size_t i = 0; i < at.nodes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) hessian.add(*place++, factor * at.k.block<3, 3>(3 * i, 3 * j));
      hessian.add_diagonal(at.nodes[i], factor * at.k.block<3, 3>(3 * i, 3 * i));
    }
  };
  bending_.over_hessian(
      u, rotations(u), [&](const Bending::Part& part) { add(part, 1); },
      [&](const Bending::Part& part) { add(part, 1 - share); });
}

}  // namespace membrane

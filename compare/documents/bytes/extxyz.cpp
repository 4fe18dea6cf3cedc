#include "compare/documents/bytes/extxyz.hpp"

#include <fmt/core.h>

#include <array>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "compare/base/file.hpp"
#include "compare/base/read_file.hpp"

namespace validate {

namespace {

struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), size = Eigen::Vector3d::Zero();
};

// Around the atoms with a margin, so that no side is flat (a plane sheet has no height).
Box box_around(std::span<const Eigen::Vector3d> positions) {
  if (positions.empty()) return {};
  Eigen::Vector3d low = positions[0], high = positions[0];
  for (const Eigen::Vector3d& x : positions) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(5);
  return {low - margin, high - low + 2 * margin};
}

}  // namespace

std::string extxyz(const Snapshot& sheet) {
  const std::size_t atoms = sheet.positions_A.size();
  if (sheet.forces_eV_per_A.size() != atoms || sheet.longest_bond_A.size() != atoms || sheet.clamped.size() != atoms) {
    throw std::invalid_argument("extxyz: positions, forces, bonds and clamp flags differ in length");
  }
  const Box box = box_around(sheet.positions_A);
  std::string text = fmt::format(
      "{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" "
      "Properties=species:S:1:pos:R:3:forces:R:3:longest_bond:R:1:clamped:I:1 pbc=\"F F F\" "
      "potential=\"{}\" load=\"{}\" depth_A={} force_eV_per_A={} length_unit=\"angstrom\" "
      "force_unit=\"eV/angstrom\"\n",
      atoms, box.size.x(), box.size.y(), box.size.z(), box.low.x(), box.low.y(), box.low.z(), sheet.potential,
      sheet.load, sheet.depth_A, sheet.force_eV_per_A);
  for (std::size_t i = 0; i < atoms; ++i) {
    const Eigen::Vector3d& x = sheet.positions_A[i];
    const Eigen::Vector3d& f = sheet.forces_eV_per_A[i];
    fmt::format_to(std::back_inserter(text), "C {:.8f} {:.8f} {:.8f} {:.8e} {:.8e} {:.8e} {:.6f} {}\n", x.x(), x.y(),
                   x.z(), f.x(), f.y(), f.z(), sheet.longest_bond_A[i], sheet.clamped[i]);
  }
  return text;
}

void write_extxyz(const Snapshot& sheet, const std::filesystem::path& file) { write_file(file, extxyz(sheet)); }

std::vector<AtomFromAbove> read_free_atoms(const std::filesystem::path& file) {
  std::istringstream in(read_if_there(file).value_or(""));
  std::vector<AtomFromAbove> atoms;
  std::string line;
  std::getline(in, line);  // how many
  std::getline(in, line);  // what the columns are
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string species;
    std::array<double, 7> number{};
    int clamped = 0;
    cells >> species;
    for (double& n : number) cells >> n;
    if (cells >> clamped; cells && clamped == 0) atoms.push_back({number[0], number[1], number[6]});
  }
  return atoms;
}

}  // namespace validate

#include "compare/documents/bytes/extxyz.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

const std::vector<Eigen::Vector3d> positions = {{-1.5, 2, -3}, {4, 5.25, 0}};
const std::vector<Eigen::Vector3d> forces = {{1e-6, 0, -0.25}, {0, 2e-7, 0}};
const std::vector<double> bonds = {1.5, 1.421};
const std::vector<int> clamped = {0, 1};

Snapshot two_atoms() { return {"airebo", "disc", 12.107, 4, positions, forces, bonds, clamped}; }

TEST(Extxyz, HasTheKeysThatReadersLookFor) {
  std::istringstream lines(extxyz(two_atoms()));
  std::string count, comment;
  std::getline(lines, count);
  std::getline(lines, comment);
  EXPECT_EQ(count, "2");
  for (const char* part : {"Lattice=\"15.5 0 0 0 13.25 0 0 0 13\"", "Origin=\"-6.5 -3 -8\"",
                           "Properties=species:S:1:pos:R:3:forces:R:3:longest_bond:R:1:clamped:I:1", "pbc=\"F F F\"",
                           "depth_A=12.107", "force_eV_per_A=4 ", "potential=\"airebo\""}) {
    EXPECT_NE(comment.find(part), std::string::npos) << part << "\nin " << comment;
  }
}

TEST(Extxyz, GivesTheAtomsBack) {
  std::istringstream lines(extxyz(two_atoms()));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  for (std::size_t i = 0; i < 2; ++i) {
    std::string species;
    Eigen::Vector3d x, f;
    double bond;
    int held;
    ASSERT_TRUE(lines >> species >> x[0] >> x[1] >> x[2] >> f[0] >> f[1] >> f[2] >> bond >> held);
    EXPECT_EQ(species, "C");
    EXPECT_LT((x - positions[i]).norm(), 1e-8);
    EXPECT_LT((f - forces[i]).norm(), 1e-8 * forces[i].norm());
    EXPECT_NEAR(bond, bonds[i], 1e-6);
    EXPECT_EQ(held, clamped[i]);
  }
  EXPECT_FALSE(lines >> line);
}

TEST(Extxyz, RefusesArraysOfDifferentLength) {
  Snapshot sheet = two_atoms();
  sheet.longest_bond_A = sheet.longest_bond_A.first(1);
  EXPECT_THROW(extxyz(sheet), std::invalid_argument);
}

TEST(Extxyz, IsWrittenAsAFile) {
  const TemporaryFolder folder;
  write_extxyz(two_atoms(), folder / "atoms.extxyz");
  EXPECT_EQ(folder.read("atoms.extxyz"), extxyz(two_atoms()));
}

}  // namespace

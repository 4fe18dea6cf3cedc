// The files in inputs/: complete, readable, and the same defaults as --help shows.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "compare/base/paper.hpp"
#include "compare/input/case_file.hpp"
#include "compare/input/potential_file.hpp"

namespace {

using namespace validate;
namespace fs = std::filesystem;

const fs::path inputs = fs::path(VALIDATE_SOURCE_INPUTS).lexically_normal();

TEST(ShippedInputs, IndentationHoldsTheDefaults) {
  Case c;
  c.radius_A = c.tip_radius_A = c.force_tolerance_eV_per_A = c.tolerance = -1;
  c.potential = "none";
  c.models = Models::membrane;
  c.judged_load = LoadKind::point;
  c.loads.clear();
  c.window.clear();
  c.pretension_eV_per_A2 = -1;
  c.past_artefact = true;
  const Origins origins = read_case(inputs / "indentation.toml", c);

  const Case defaults;
  EXPECT_EQ(c.radius_A, defaults.radius_A);
  EXPECT_EQ(c.potential, defaults.potential);
  EXPECT_EQ(c.loads, defaults.loads);
  EXPECT_EQ(c.tip_radius_A, defaults.tip_radius_A);
  EXPECT_EQ(c.depth_max_A, defaults.depth_max_A);
  EXPECT_EQ(c.depth_step_A, defaults.depth_step_A);
  EXPECT_EQ(c.forces_eV_per_A, defaults.forces_eV_per_A);
  EXPECT_EQ(c.pretension_eV_per_A2, defaults.pretension_eV_per_A2);
  EXPECT_EQ(c.models, defaults.models);
  EXPECT_FALSE(c.E_eV_per_A3 || c.thickness_A || c.nu);
  EXPECT_EQ(c.force_tolerance_eV_per_A, defaults.force_tolerance_eV_per_A);
  EXPECT_EQ(c.past_artefact, defaults.past_artefact);
  EXPECT_EQ(c.judged_load, defaults.judged_load);
  EXPECT_EQ(c.window, defaults.window);
  EXPECT_EQ(c.tolerance, defaults.tolerance);
  EXPECT_TRUE(check(c, origins).empty());
}

TEST(ShippedInputs, Figure4IsThePapers) {
  Case c = bulge_defaults();
  c.pressures_eV_per_A3.clear();
  Origins origins = read_case(inputs / "figure4.toml", c);
  settle_size(c, origins);
  EXPECT_EQ(2 * c.radius_A, paper::side_A);
  EXPECT_EQ(c.pressures_eV_per_A3, std::vector{paper::pressure_eV_per_A3});
  EXPECT_EQ(c.E_eV_per_A3, paper::E_eV_per_A3);
  EXPECT_EQ(c.thickness_A, paper::thickness_A);
  EXPECT_EQ(c.nu, paper::nu);
  EXPECT_EQ(c.law.name, "svk");
  EXPECT_EQ(c.pressures_eV_per_A3, bulge_defaults().pressures_eV_per_A3);
  EXPECT_TRUE(check(c, origins).empty());
}

TEST(ShippedInputs, EveryPotentialIsCompleteAndFindsItsParameters) {
  const auto names = available_potentials(inputs / "potentials");
  EXPECT_GE(names.size(), 5u);
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const PotentialFile file = read_potential(name, inputs / "potentials", "--potential");
    EXPECT_EQ(file.potential.name, name);
    EXPECT_FALSE(file.potential.description.empty());
    EXPECT_NE(file.potential.citation.find("doi:10."), std::string::npos) << file.potential.citation;
    EXPECT_EQ(file.sha256.size(), 64u);
    EXPECT_TRUE(fs::path(file.potential.file).is_absolute());
    EXPECT_TRUE(file.warnings.empty()) << file.warnings.front();
  }
}

}  // namespace

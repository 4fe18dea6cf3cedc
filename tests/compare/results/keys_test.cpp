#include "compare/base/keys.hpp"

#include <gtest/gtest.h>

#include <map>

#include "compare/results/fit.hpp"

using namespace validate;

TEST(Keys, CarryTheUnit) {
  EXPECT_EQ(key(Field{"depth", unit::length}), "depth_A");
  EXPECT_EQ(key(Field{"depth-max", unit::length}), "depth_max_A");
  EXPECT_EQ(key(Field{"force", unit::force}), "force_eV_per_A");
  EXPECT_EQ(key(Field{"E", unit::stress}), "E_eV_per_A3");
  EXPECT_EQ(key(Field{"wall", unit::second}), "wall_s");
  EXPECT_EQ(key(Field{"nu", unit::none}), "nu");
  EXPECT_THROW(key(Field{"x", "furlong"}), std::logic_error);
}

TEST(Keys, MembraneForcesComeInBothUnits) {
  Fit fit;
  fit.Eh_eV_per_A2 = 2;
  std::map<std::string, double> found;
  describe_with_twins(fit, [&found](const Field& field, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, double>) found[key(field)] = value;
    if constexpr (std::is_same_v<Value, std::optional<double>>)
      if (value) found[key(field)] = *value;
  });
  EXPECT_DOUBLE_EQ(found.at("Eh_eV_per_A2"), 2);
  EXPECT_DOUBLE_EQ(found.at("Eh_N_per_m"), 2 * 16.02176634);  // exact: elementary charge, SI 2019
  EXPECT_TRUE(found.contains("pretension_stderr_N_per_m"));
  EXPECT_FALSE(found.contains("correlation_N_per_m"));
}

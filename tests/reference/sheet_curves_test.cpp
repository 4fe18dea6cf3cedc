// compare/verify_fit/sheet_curves.json, computed anew.
#include "reference/sheet_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace reference {
namespace {

TEST(SheetCurves, TheFileHoldsWhatTheSolversSay) {
  std::ifstream file(SHEET_CURVES_JSON);
  const auto kept = nlohmann::json::parse(file);
  EXPECT_EQ(kept.at("Eh_N_per_m"), drum_Eh_N_per_m);
  EXPECT_EQ(kept.at("nu"), drum_nu);
  EXPECT_EQ(kept.at("radius_nm"), drum_radius_nm);
  constexpr int every = 6;
  const auto curves = sheet_curves(every);
  ASSERT_EQ(kept.at("curves").size(), curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const SheetCurve& curve = curves[i];
    const auto& of_file = kept.at("curves")[i];
    SCOPED_TRACE(curve.tip + " " + std::to_string(curve.tip_radius_nm) + " " +
                 std::to_string(curve.pretension_N_per_m));
    EXPECT_EQ(of_file.at("tip"), curve.tip);
    EXPECT_EQ(of_file.at("tip_radius_nm"), curve.tip_radius_nm);
    EXPECT_EQ(of_file.at("pretension_N_per_m"), curve.pretension_N_per_m);
    ASSERT_EQ(of_file.at("depth_nm").size(), every * curve.depth_nm.size());
    ASSERT_EQ(of_file.at("force_nN").size(), every * curve.depth_nm.size());
    for (std::size_t k = 0; k < curve.depth_nm.size(); ++k) {
      EXPECT_NEAR(of_file.at("depth_nm")[every * k].get<double>() / curve.depth_nm[k], 1, 1e-12);
      EXPECT_NEAR(of_file.at("force_nN")[every * k].get<double>() / curve.force_nN[k], 1, 1e-9);
    }
  }
}

// What is interpolated, F/d over ln d, bends so little that eight values give the ninth.
TEST(SheetCurves, NeighboursForetellAForce) {
  std::ifstream file(SHEET_CURVES_JSON);
  for (const auto& curve : nlohmann::json::parse(file).at("curves")) {
    const auto d = curve.at("depth_nm").get<std::vector<double>>(), f = curve.at("force_nN").get<std::vector<double>>();
    for (std::size_t i = 4; i + 4 < d.size(); ++i) {
      double foretold = 0;
      for (std::size_t j = i - 4; j <= i + 4; ++j) {
        if (j == i) continue;
        double weight = 1;
        for (std::size_t k = i - 4; k <= i + 4; ++k)
          if (k != i && k != j) weight *= std::log(d[i] / d[k]) / std::log(d[j] / d[k]);
        foretold += weight * f[j] / d[j];
      }
      // At twice the distance of an interpolation: its error is 60 times larger.
      EXPECT_NEAR(foretold * d[i] / f[i], 1, 6e-6) << curve.at("tip") << " " << d[i];
    }
  }
}

}  // namespace
}  // namespace reference

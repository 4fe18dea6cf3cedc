// What is drawn, as a table.
#include "compare/documents/plots/plot_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace validate;

namespace {

Plot two_panels() {
  const Axis x{.label = "x", .unit = "Å", .key = "x_A"}, y{.label = "force", .unit = "nN", .key = "force_nN"};
  Plot plot{.title = "both"};
  plot.panels = {{.title = "say \"A\"", .x = x, .y = y}, {.title = {}, .x = x, .y = y}};
  plot.panels[0].curves = {{.name = "line", .x = {1, 2, 3}, .y = {0.5, NAN, 1.5}},
                           {.name = "band", .x = {1}, .y = {2}, .y_high = {3}}};
  plot.panels[1].curves = {{.name = "atoms", .x = {4}, .y = {5}, .value = {1.42}}};
  return plot;
}

TEST(PlotCsv, OneRowAPoint) {
  EXPECT_EQ(plot_csv(two_panels(), "run.h5"),
            "# title: both\n"
            "# panel \"say \"\"A\"\"\": force (nN) against x (Å)\n"
            "# panel \"2\": force (nN) against x (Å)\n"
            "panel,curve,x_key,y_key,x,y,upper_or_value\n"
            "\"say \"\"A\"\"\",\"line\",x_A,force_nN,1,0.5,\n"
            "\"say \"\"A\"\"\",\"line\",x_A,force_nN,3,1.5,\n"
            "\"say \"\"A\"\"\",\"band\",x_A,force_nN,1,2,3\n"
            "\"2\",\"atoms\",x_A,force_nN,4,5,1.42\n");
}

TEST(PlotCsv, TrianglesHaveTheirCornersWhereAsked) {
  Plot plot = two_panels();
  plot.panels.resize(1);
  plot.panels[0].curves.resize(1);
  plot.panels[0].maps = {{.name = "s", .key = "s_N_per_m", .corners = {{{{0, 0}, {3, 0}, {0, 3}}}}, .value = {7}}};
  const std::string with = plot_csv(plot, "run.h5"), without = plot_rows(plot, Corners::left_out);
  EXPECT_NE(with.find("upper_or_value,x1_A,y1_A,x2_A,y2_A,x3_A,y3_A\n"), std::string::npos) << with;
  EXPECT_NE(with.find("\"s_N_per_m\",x_A,force_nN,1,1,7,0,0,3,0,0,3\n"), std::string::npos) << with;
  EXPECT_NE(with.find("\"line\",x_A,force_nN,1,0.5,,,,,,,\n"), std::string::npos) << with;
  EXPECT_NE(without.find("\"s_N_per_m\",x_A,force_nN,1,1,7\n"), std::string::npos) << without;
  EXPECT_EQ(with.find("mirror"), std::string::npos);
  plot.panels[0].maps[0].quarter = true;
  EXPECT_NE(plot_csv(plot, "run.h5").find("mirror images"), std::string::npos);
}

TEST(PlotCsv, LargeMapsAreLeftToTheirFile) {
  Plot plot = two_panels();
  TriangleMap map{.name = "s", .key = "s_N_per_m", .corners = {}, .value = {}};
  map.corners.resize(20001, {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)});
  map.value.resize(20001, 1);
  plot.panels[1].maps = {map};
  const std::string text = plot_csv(plot, "run.h5");
  EXPECT_NE(text.find("# maps: 20001 triangles, left to run.h5\n"), std::string::npos);
  EXPECT_EQ(text.find("s_N_per_m"), std::string::npos);
  EXPECT_NE(text.find("\"atoms\""), std::string::npos);
  map.corners.pop_back(), map.value.pop_back();
  plot.panels[1].maps = {map};
  EXPECT_NE(plot_csv(plot, "run.h5").find("s_N_per_m"), std::string::npos);
}

}  // namespace

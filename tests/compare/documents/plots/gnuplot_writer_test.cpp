// Plots as gnuplot's text.
#include "compare/documents/plots/gnuplot_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "compare/documents/plots/gnuplot_data.hpp"

using namespace validate;

namespace {

std::string script(const Plot& plot) {
  return gnuplot_script(plot, {{PictureFormat::svg, "/run/it's.svg"}, {PictureFormat::png, "/run/a.png"}});
}

Panel panel() {
  return {.title = "κ's panel",
          .x = {.label = "depth", .unit = "Å", .key = "depth_A", .low = 0},
          .y = {.label = "ratio", .unit = {}, .key = "ratio"}};
}

void expect(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

TEST(GnuplotWriter, OneScriptForBothPicturesWithTheDataOnce) {
  Panel one = panel();
  one.curves = {{.name = "atoms", .x = {1, 2}, .y = {3, NAN}, .colour = Colour::blue, .points = Points{}}};
  const std::string text = script({.panels = {one}, .width = 500, .height = 300});
  EXPECT_EQ(text.find("set encoding utf8\n$p0c0 << EOD\n1 3\n2 NaN\nEOD\nset terminal svg size 500,300"), 0u) << text;
  expect(text,
         {"set output '/run/it''s.svg'", "set terminal pngcairo size 1000,600",
          "map_border = 'border retrace'\nset output '/run/a.png'", "set title 'κ''s panel' font ',14'",
          "set xlabel 'depth (Å)'", "set ylabel 'ratio'", "set xrange [0:*]", "set yrange [*:*]", "set minussign"});
  EXPECT_EQ(text.find("EOD\n1 3", 40), std::string::npos);
  EXPECT_EQ(text.find("multiplot"), std::string::npos);
  EXPECT_EQ(text, script({.panels = {one}, .width = 500, .height = 300}));
}

TEST(GnuplotWriter, CurvesHaveLinesMarkersOrBands) {
  Panel one = panel();
  one.legend = Legend::right_bottom;
  one.curves = {{.name = "line", .x = {1}, .y = {1}, .colour = Colour::green, .line = Line{Dash::dashed, 2}},
                {.name = "both", .x = {1}, .y = {1}, .line = Line{}, .points = Points{Marker::square, 0.5, true}},
                {.name = "hidden", .x = {1}, .y = {1}, .points = Points{}, .in_legend = false},
                {.name = "band", .x = {1}, .y = {1}, .y_high = {2}, .colour = Colour::grey},
                {.name = "empty", .x = {}, .y = {}}};
  const std::string text = script({.panels = {one}});
  expect(text, {"$p0c0 using 1:2 with lines lc rgb '#009E73' lw 2 dt '-' title 'line'",
                "$p0c1 using 1:2 with linespoints lc rgb '#000000' lw 1.5 dt 1 pt 4 ps 0.5 title 'both'",
                "$p0c2 using 1:2 with points lc rgb '#000000' pt 7 ps 0.7 notitle",
                "$p0c3 using 1:2:3 with filledcurves fc rgb '#999999' fs solid 0.5 noborder title 'band'",
                "set key inside right bottom"});
  EXPECT_EQ(text.find("empty"), std::string::npos);
}

TEST(GnuplotWriter, APlotOfNothingIsStillAPlot) { expect(script({.panels = {panel()}}), {"plot NaN notitle"}); }

TEST(GnuplotWriter, ZonesAndMarksCrossThePanel) {
  Panel one = panel();
  one.zones = {{.from = 22, .colour = Colour::blue, .name = "zone", .edge = true},
               {.along = Along::y, .from = 0.9, .to = 1.1}};
  one.marks = {{.along = Along::y, .at = 1, .dash = Dash::dotted}};
  expect(
      script({.panels = {one}}),
      {"rectangle from first 22,graph 0 to graph 1,graph 1 fc rgb '#0072B2'",
       "arrow from first 22,graph 0 to first 22,graph 1", "NaN with boxes fs solid 0.25 lc rgb '#0072B2' title 'zone'",
       "rectangle from graph 0,first 0.9 to graph 1,first 1.1 fc rgb '#999999'",
       "arrow from graph 0,first 1 to graph 1,first 1 nohead lc rgb '#000000' lw 1 dt '.'"});
}

TEST(GnuplotWriter, LogarithmicAxesHaveNamedPlaces) {
  Panel one = panel();
  one.x.low.reset();
  one.x.logarithmic = one.y.logarithmic = true;
  one.curves = {{.name = "a", .x = {1e-3, 4e-3}, .y = {10, 1e6}, .line = Line{}}};
  const std::string text = script({.panels = {one}});
  expect(text, {"set logscale x\n", "'0.001' 0.001, '0.002' 0.002, '0.003' 0.003, '0.004' 0.004", "set logscale y\n",
                "'10' 10, '100' 100, '1000' 1000"});
  EXPECT_EQ(text.find("'20' 20"), std::string::npos);
}

TEST(GnuplotWriter, BarsAreStackedBySign) {
  Panel one = panel();
  one.x.categories = {"0.1", "0.2"};
  one.bars = {{.name = "up", .colour = Colour::blue, .y = {2, NAN}},
              {.name = "down", .colour = Colour::black, .y = {-1, -3}},
              {.name = "more", .colour = Colour::grey, .y = {4, -2}}};
  const std::string data = gnuplot_data({.panels = {one}});
  expect(data, {"$p0b0 << EOD\n0 2 -0.35 0.35 0 2\nEOD\n", "$p0b1 << EOD\n0 -1 -0.35 0.35 -1 0\n1 -3 0.65 1.35 -3 0\n",
                "$p0b2 << EOD\n0 6 -0.35 0.35 2 6\n1 -5 0.65 1.35 -5 -3\n"});
  expect(script({.panels = {one}}), {"with boxxyerror fs solid 0.85 noborder fc rgb '#0072B2' title 'up'",
                                     "set xtics rotate by 45 right ('0.1' 0, '0.2' 1)", "set xrange [-0.6:1.6]"});
}

TEST(GnuplotWriter, AQuarterIsDrawnWithItsMirrorImages) {
  Panel one = panel();
  one.maps = {{.name = "m", .key = "m_A", .corners = {{{{0, 0}, {2, 0}, {2, 1}}}}, .value = {7}}};
  EXPECT_EQ(gnuplot_data({.panels = {one}}),
            "$p0m0 << EOD\n0 0 0 7\n2 0 0 7\nNaN NaN NaN NaN\n\n2 1 0 7\n2 1 0 7\nNaN NaN NaN NaN\nEOD\n");
  one.maps[0].quarter = true;
  const std::string data = gnuplot_data({.panels = {one}});
  for (const char* corner : {"2 1 0 7", "-2 1 0 7", "2 -1 0 7", "-2 -1 0 7"}) expect(data, {corner});
}

TEST(GnuplotWriter, NeighboursOfOneColourAreDrawnAtOnce) {
  Panel one = panel();
  one.maps = {{.name = "m",
               .key = "m_A",
               .corners = {{{{0, 0}, {2, 0}, {2, 1}}}, {{{2, 1}, {0, 0}, {0, 1}}}, {{{5, 0}, {7, 0}, {7, 1}}}},
               .value = {7, 7, 8}}};
  const std::string gap = "NaN NaN NaN NaN\n";
  EXPECT_EQ(gnuplot_data({.panels = {one}}), "$p0m0 << EOD\n2 0 0 7\n2 1 0 7\n" + gap + "5 0 0 8\n7 0 0 8\n" + gap +
                                                 "\n0 0 0 7\n0 1 0 7\n" + gap + "7 1 0 8\n7 1 0 8\n" + gap + "EOD\n");
  one.maps[0].value = {7, 7.01, 8};  // more than half a colour apart
  EXPECT_NE(gnuplot_data({.panels = {one}}).find("2 1 0 7.01\n0 0 0 7.01\n"), std::string::npos);
  one.maps[0].value = {7, 7, 7};  // of one colour, but the last is apart
  EXPECT_NE(gnuplot_data({.panels = {one}}).find("5 0 0 7\n7 0 0 7\n"), std::string::npos);
}

/// Between the corners a value is linear: a triangle from 0 to 2 is parted where a band of the scale 0 … 2 ends.
TEST(GnuplotWriter, ValuesAtCornersAreDrawnInBandsThatCoverTheTriangle) {
  Panel one = panel();
  one.maps = {{.name = "m", .key = "m_A", .corners = {{{{0, 0}, {16, 0}, {0, 1}}}}, .value = {1}}};
  one.maps[0].at_corners = {{0, 2, 0}};
  one.scale = {.low = 0, .high = 2};
  std::istringstream rows(gnuplot_data({.panels = {one}}));
  std::vector<std::array<double, 4>> points;
  for (std::string line; std::getline(rows, line);) {
    std::array<double, 4> p{};
    std::istringstream numbers(line);
    if (numbers >> p[0] >> p[1] >> p[2] >> p[3]) points.push_back(p);
  }
  ASSERT_EQ(points.size() % 4, 0u);
  const std::size_t pieces = points.size() / 4;
  ASSERT_EQ(pieces, 12u);
  double area = 0;
  for (std::size_t k = 0; k < pieces; ++k) {
    const auto &a = points[2 * k], &b = points[2 * k + 1], &d = points[2 * (pieces + k)],
               &c = points[2 * (pieces + k) + 1];
    area += 0.5 * std::abs((c[0] - a[0]) * (d[1] - b[1]) - (d[0] - b[0]) * (c[1] - a[1]));
    EXPECT_NEAR(a[3], (static_cast<double>(k) + 0.5) / 6, 1e-5) << "the middle of its band";
    for (const auto& corner : {a, b, c, d}) EXPECT_NEAR(corner[0] / 8, a[3], 1.0 / 12 + 1e-5);
  }
  EXPECT_NEAR(area, 8, 1e-4);
}

TEST(GnuplotWriter, ABarThatEndsBelowTheLargestValueSaysSo) {
  Panel one = panel();
  one.maps = {{.name = "m", .key = "m_A", .corners = {{{{0, 0}, {2, 0}, {2, 1}}}}, .value = {4.32}}};
  one.scale = {.label = "eV/Å³", .low = 0.125, .high = 0.65};
  expect(script({.panels = {one}}), {"set cbtics add ('≥ 0.65' 0.65)"});
  one.scale.high = 5;
  EXPECT_EQ(script({.panels = {one}}).find("≥"), std::string::npos);
}

TEST(GnuplotWriter, MapsHaveAColourBar) {
  Panel range = panel(), classes = panel();
  range.maps = {{.name = "m", .key = "m_A", .corners = {{{{0, 0}, {2, 0}, {2, 1}}}}, .value = {7}}};
  range.curves = {{.name = "rays", .x = {0, 1}, .y = {0, 1}, .colour = Colour::white, .line = Line{}, .strokes = true}};
  range.scale = {.label = "N/m", .low = -1};
  classes.curves = {{.name = "atoms", .x = {0}, .y = {0}, .value = {1}, .points = Points{}}};
  classes.scale.classes = {{"taut", Colour::sky}, {"slack", Colour::grey}};
  const std::string text = script({.title = "both", .panels = {range, classes}, .columns = 2});
  expect(text, {"set multiplot layout 1,2 title 'both' font ',14'", "set cbrange [-1:7]", "set label 'N/m'",
                "splot $p0m0 using 1:2:3:4 with pm3d notitle, \\\n     $p0c0 using 1:2:(0) with lines lc rgb '#ffffff'",
                "set palette defined (0 '#56B4E9', 1 '#999999') maxcolors 2", "set cbtics ('taut' 0, 'slack' 1)",
                "splot $p1c0 using 1:2:(0):3 with points lc palette pt 7", "$p0c0 << EOD\n0 0\n1 1\n\n\nEOD\n"});
}

}  // namespace

// What is drawn of a bulge, of a potential, of a measured curve and of the paper's figures, as data.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/base/units.hpp"
#include "compare/documents/plots/from_above.hpp"
#include "compare/documents/plots/measured_curve_plot.hpp"
#include "compare/documents/plots/pressed_atoms_plot.hpp"
#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/documents/plots/stress_strain.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/fitting/measured_fit.hpp"
#include "compare/fitting/models/eq16.hpp"

using namespace validate;

namespace {

/// A square's quarter, pressed until it wrinkles.
SheetPicture bulge() {
  membrane::Problem problem;
  problem.sheet = membrane::RectangleSheet{.length_x_A = 220, .length_y_A = 220, .cells_x = 10, .cells_y = 10};
  problem.law = membrane::StVenantKirchhoff{8, 0.19};
  problem.load = membrane::PressureLoad{};
  problem.control = membrane::Control::force;
  problem.levels = {5e-4};
  SheetAlbum album(problem, 1.37, false);
  membrane::solve(problem, [&](const membrane::Step& step) {
    album.keep(step);
    return true;
  });
  return album.pictures().at(0);
}

TEST(SheetMaps, ThreePanelsOverTheDeformedQuarter) {
  const SheetPicture picture = bulge();
  const Plot plot = sheet_plot(picture);
  ASSERT_EQ(plot.panels.size(), 3u);
  for (const Panel& panel : plot.panels) {
    const TriangleMap& map = panel.maps.at(0);
    EXPECT_TRUE(map.quarter);
    EXPECT_EQ(map.value.size(), picture.mesh.triangles.size());
    EXPECT_EQ(map.corners.size(), map.value.size());
  }
  const int node = picture.mesh.triangles[0].nodes[0];
  EXPECT_DOUBLE_EQ(plot.panels[0].maps[0].corners[0][0].x(),
                   picture.mesh.nodes[static_cast<std::size_t>(node)].x() +
                       picture.displacement[static_cast<std::size_t>(3 * node)]);
  EXPECT_EQ(plot.panels[0].maps[0].key, "cauchy_1_eV_per_A3");
  EXPECT_EQ(plot.panels[2].scale.classes.size(), 3u);
}

TEST(SheetMaps, RaysAreStrokesInWrinkledTrianglesWithTheirImages) {
  const SheetPicture picture = bulge();
  const auto& state = column(picture.triangles, "state");
  ASSERT_GT(std::ranges::count(state, 1.0), 0);
  const PlotCurve rays = sheet_plot(picture).panels[2].curves.at(0);
  EXPECT_TRUE(rays.strokes);
  ASSERT_GT(rays.x.size(), 0u);
  EXPECT_EQ(rays.x.size() % 8, 0u);  // two ends, four images
  EXPECT_NEAR(rays.x[0] + rays.x[4], 0, 1e-12);
  EXPECT_NEAR(rays.y[0] + rays.y[2], 0, 1e-12);
}

/// A pressed sheet's run that has kept its picture.
validate::Run pictured(double tip_A, double a_A) {
  validate::Run run;
  run.load = LoadKind::disc;
  run.tip_A = tip_A, run.a_A = a_A;
  run.continuum().pictures = std::make_shared<const std::vector<SheetPicture>>(1, bulge());
  return run;
}

TEST(FromAbove, AtomsByTheirBondsBesideTheMembranesForce) {
  const validate::Run run = pictured(10, 110);
  const std::vector<AtomFromAbove> atoms = {{1, 2, 1.42}, {-30, 4, 1.5}};
  const Plot both = from_above_plot(LoadKind::disc, atoms, &run);
  ASSERT_EQ(both.panels.size(), 2u);
  EXPECT_EQ(both.panels[0].curves.at(0).value, (std::vector{1.42, 1.5}));
  EXPECT_NEAR(*both.panels[0].x.high, 1.02 * 30, 1e-12);
  const TriangleMap& map = both.panels[1].maps.at(0);
  const SheetPicture& picture = run.continuum().pictures->back();
  EXPECT_TRUE(map.quarter);
  ASSERT_EQ(map.value.size(), picture.mesh.triangles.size());
  EXPECT_NEAR(map.value[7], N_per_m_per_eV_per_A2 * 1.37 * column(picture.triangles, "cauchy_1_eV_per_A3")[7], 1e-12);
  EXPECT_EQ(from_above_plot(LoadKind::disc, {}, &run).panels.size(), 1u);
  EXPECT_EQ(from_above_plot(LoadKind::disc, atoms, nullptr).panels.size(), 1u);
  const validate::Run forgotten;  // nothing was kept of it
  EXPECT_TRUE(from_above_plot(LoadKind::disc, {}, &forgotten).panels.empty());
}

TEST(FromAbove, UnderAPointTheMapBeginsOutsideTheCentre) {
  const validate::Run point = pictured(0, 1000);  // a hundredth of it is 10 Å
  const std::size_t all = point.continuum().pictures->back().mesh.triangles.size();
  const std::size_t drawn = from_above_plot(LoadKind::point, {}, &point).panels.at(0).maps.at(0).value.size();
  EXPECT_LT(drawn, all);
  EXPECT_GT(drawn + 5, all);
}

TEST(StressStrain, DottedFromTheArtefactLengthOnWithoutAGap) {
  Result card;
  card.command = Command::potential;
  card.potential.name = "some";
  card.potential.artefact_bond_A = 1.7;
  StressCurve curve;
  curve.direction = "zigzag";
  curve.strain = {0, 0.1, 0.2, 0.3};
  curve.stress_eV_per_A2 = {0, 1, 2, 5};
  curve.longest_bond_A = {1.4, 1.6, 1.7, 1.9};
  card.stress_curves = {curve};
  const Panel panel = stress_strain_plot(card).panels.at(0);
  ASSERT_EQ(panel.curves.size(), 2u);
  EXPECT_EQ(panel.curves[0].x, (std::vector{0.0, 10.0}));
  EXPECT_EQ(panel.curves[1].x, (std::vector{10.0, 20.0, 30.0}));
  EXPECT_EQ(panel.curves[1].line->dash, Dash::dotted);
  EXPECT_FALSE(panel.curves[1].in_legend);
  EXPECT_NEAR(panel.curves[1].y.back(), 5 * N_per_m_per_eV_per_A2, 1e-12);
}

TEST(MeasuredCurve, FourPanelsInNanometresAndNanonewtons) {
  MeasuredOptions options;
  options.geometry = {.a_A = 5000, .nu = 0.165};
  MeasuredCurve curve;
  curve.file = "folder/some.csv";
  const Eq16 truth{5000, 0.165};
  for (int i = 40; i > 0; --i) {  // pulled back: the depth falls
    curve.depth_A.push_back(25.0 * i);
    curve.force_eV_per_A.push_back(truth.force(25.0 * i, 21.3, 0.02));
  }
  const FittedCurve result = evaluate(curve, options);
  const Plot plot = measured_plot(result);
  ASSERT_EQ(plot.panels.size(), 4u);
  EXPECT_EQ(plot.title, "some.csv");
  const PlotCurve &data = plot.panels[0].curves.at(0), &model = plot.panels[0].curves.at(1);
  EXPECT_TRUE(std::ranges::is_sorted(data.x));
  EXPECT_DOUBLE_EQ(data.x.back(), 100);
  EXPECT_DOUBLE_EQ(data.y.back(), nN_per_eV_per_A * curve.force_eV_per_A[0]);
  EXPECT_NEAR(model.y.back(), data.y.back(), 1e-6 * data.y.back());  // Eq. 16 fits itself
  EXPECT_EQ(plot.panels[0].curves.size(), continuum_fit(result.fits) ? 3u : 2u);
  // Residuals are those of the fit to quote, the membrane, whose pretension term Eq. 16 has not.
  EXPECT_EQ(plot.panels[1].curves.at(0).name, "data − membrane");
  for (const double residual : plot.panels[1].curves.at(0).y) EXPECT_NEAR(residual, 0, 2e-3 * data.y.back());
  const Axis& modulus = plot.panels[2].y;
  EXPECT_NEAR((*modulus.low + *modulus.high) / 2, N_per_m_per_eV_per_A2 * closed_form_fit(result.fits)->Eh_eV_per_A2,
              1e-9);
}

TEST(PressedAtoms, OnePressureIsACrossSectionOnly) {
  Result result;
  EXPECT_TRUE(pressed_atoms_plot(result).panels.empty());
  result.runs.resize(2);
  result.runs[1].model = Model::atomistic;
  settle_part(result.runs[1]);
  for (validate::Run& run : result.runs) {
    run.load = LoadKind::pressure;
    run.pressure_eV_per_A3 = {1e-3};
  }
  result.runs[0].depth_A = {3.2}, result.runs[1].depth_A = {3};
  result.runs[0].cross_section = {{-1, 0, 1}, {0, -3.2, 0}};
  EXPECT_TRUE(pressed_atoms_plot(result).panels.empty());  // the atoms have none
  result.runs[1].cross_section = {{-1, 0, 1}, {0, -3, 0}};
  EXPECT_EQ(pressed_atoms_plot(result).panels.size(), 1u);
  result.runs[1].depth_A.push_back(4),
      result.runs[1].pressure_eV_per_A3.push_back(2e-3);  // the membrane has none there
  const Plot plot = pressed_atoms_plot(result);
  ASSERT_EQ(plot.panels.size(), 2u);
  EXPECT_TRUE(plot.panels[0].x.logarithmic && plot.panels[0].y.logarithmic);
  EXPECT_EQ(plot.panels[0].curves[0].x, std::vector{1e-3});
  EXPECT_EQ(plot.panels[0].curves[1].x, (std::vector{1e-3, 2e-3}));
  EXPECT_EQ(plot.panels[1].curves[0].y, result.runs[0].cross_section.z_A);
  EXPECT_EQ(plot.panels[1].curves[1].y, result.runs[1].cross_section.z_A);
}

TEST(PaperFigure, TwoPanelsToARow) {
  PaperFigure figure;
  figure.number = 7, figure.title = "seven";
  figure.panels.resize(3);
  const Plot plot = plot_of(figure);
  EXPECT_EQ(plot.title, "Figure 7: seven");
  EXPECT_EQ(plot.columns, 2);
  EXPECT_EQ(plot.height, 2 * 560);
}

}  // namespace

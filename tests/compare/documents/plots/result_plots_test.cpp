// What is drawn of a run, as data.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/base/units.hpp"
#include "compare/documents/plots/explanation_bars.hpp"
#include "compare/documents/plots/force_depth.hpp"
#include "compare/documents/plots/ratio.hpp"
#include "compare/documents/plots/window_scan.hpp"
#include "tests/compare/results/sample_result.hpp"

using namespace validate;

namespace {

std::vector<std::string> names(const Panel& panel) {
  std::vector<std::string> all;
  for (const PlotCurve& curve : panel.curves) all.push_back(curve.name);
  return all;
}

const PlotCurve& curve(const Panel& panel, const std::string& name) {
  const auto found = std::ranges::find(panel.curves, name, &PlotCurve::name);
  if (found == panel.curves.end()) throw std::out_of_range(name);
  return *found;
}

TEST(ForceDepth, ArtefactPointsAreACurveOfTheirOwnAndTheirZoneIsShaded) {
  const Result result = sample::full();
  const Panel panel = force_depth_plot(result).panels.at(0);
  ASSERT_EQ(result.runs[0].load, LoadKind::point);
  ASSERT_TRUE(result.runs[0].atoms().artefact.back());
  const PlotCurve &usable = curve(panel, "atoms"), &artefact = curve(panel, "atoms, bond ≥ 1.70 Å");
  EXPECT_EQ(usable.x.size() + artefact.x.size(), result.runs[0].depth_A.size());
  EXPECT_EQ(artefact.x, std::vector{22.0});
  EXPECT_TRUE(artefact.points->open);
  EXPECT_FALSE(usable.points->open);
  ASSERT_EQ(panel.zones.size(), 1u);  // the disc's bonds stay shorter
  EXPECT_EQ(panel.zones[0].from, 22);
  EXPECT_EQ(panel.zones[0].name, "artefact zone, bond ≥ 1.70 Å");
  EXPECT_LE(std::ranges::count_if(panel.curves, &PlotCurve::in_legend) + 1, 6);
  EXPECT_TRUE(force_depth_plot(result).panels.at(1).zones.empty());  // the disc's panel
  EXPECT_TRUE(force_depth_plot(sample::membrane_only()).panels.at(0).zones.empty());
}

TEST(ForceDepth, MembranesGoThroughTheirPointsAndEq16HasTheirConstants) {
  const Result result = sample::full();
  const Panel panel = force_depth_plot(result).panels.at(0);
  const PlotCurve &paper = curve(panel, "membrane, paper constants"), &eq16 = curve(panel, "Eq. 16, card constants");
  EXPECT_EQ(paper.line->dash, Dash::dashed);
  EXPECT_EQ(paper.x.front(), 1);  // nothing is known below the first point
  EXPECT_DOUBLE_EQ(paper.x.back(), 25);
  EXPECT_EQ(eq16.x.front(), 0);
  EXPECT_EQ(eq16.y.front(), 0);
  EXPECT_NEAR(*panel.x.high, 1.04 * 25, 1e-12);
  EXPECT_EQ(panel.title, "point load");
  EXPECT_EQ(force_depth_plot(result).title, "airebo, R = 110 Å, tip radius 10 Å");
}

TEST(ForceDepth, TheLegendLeavesTheCornerWhereACurvePasses) {
  EXPECT_EQ(force_depth_plot(sample::full()).panels.at(0).legend, Legend::left_top);
  Result concave = sample::membrane_only();
  for (double& force : concave.runs[0].force_eV_per_A) force = std::pow(force, 0.1);
  EXPECT_EQ(force_depth_plot(concave).panels.at(0).legend, Legend::right_bottom);
}

TEST(Ratio, ABandOfTheToleranceAndOpenPointsInTheArtefactZone) {
  const Result result = sample::full();
  const Panel panel = ratio_plot(result).panels.at(0);
  ASSERT_EQ(panel.zones.size(), 1u);
  EXPECT_DOUBLE_EQ(panel.zones[0].from, 1 - result.resolved.tolerance);
  EXPECT_DOUBLE_EQ(panel.zones[0].to, 1 + result.resolved.tolerance);
  ASSERT_EQ(panel.marks.size(), 2u);
  EXPECT_EQ(panel.marks[0].at, result.agreement->window[0]);
  const Comparison& c = result.comparisons.at(0);
  const auto inside = static_cast<std::size_t>(std::ranges::count(c.regime, Regime::artefact));
  ASSERT_GT(inside, 0u);
  const std::string name = std::string(to_string(c.load)) + ", membrane, card constants";
  EXPECT_EQ(curve(panel, name).x.size(), c.depth_A.size() - inside);
  EXPECT_EQ(curve(panel, name + ", artefact zone").x.size(), inside + 1);  // from the last usable point on
  EXPECT_EQ(curve(panel, name + ", artefact zone").x.front(), curve(panel, name).x.back());
  EXPECT_FALSE(curve(panel, name + ", artefact zone").in_legend);
  EXPECT_TRUE(ratio_plot(sample::membrane_only()).panels.empty());
}

TEST(ForceDepth, EveryLoadHasItsPanelAndBelowItWhatIsLeft) {
  Result result = sample::full();
  result.agreement->ratios = {{12, 1.004, 0.001, 0.002}};
  const Plot plot = force_depth_plot(result);
  ASSERT_EQ(plot.panels.size(), 4u);  // point and disc, and what is left of each
  EXPECT_EQ(plot.columns, 2);
  EXPECT_EQ(plot.panels[1].title, "disc load");
  const Panel& left = plot.panels[3];
  EXPECT_EQ(left.y.key, "difference_percent");
  EXPECT_EQ(left.x.high, plot.panels[1].x.high);
  const PlotCurve& bars = curve(left, "95 %");
  ASSERT_EQ(bars.y.size(), 2u);
  EXPECT_NEAR(bars.y[1] - bars.y[0], 2 * 100 * 2 * std::hypot(0.001, 0.002), 1e-12);
  EXPECT_NEAR((bars.y[0] + bars.y[1]) / 2, 0.4, 1e-12);
  EXPECT_EQ(curve(left, "atoms / continuum − 1").y.size(), result.comparisons[1].depth_A.size());
  ASSERT_EQ(left.zones.size(), 1u);
  EXPECT_DOUBLE_EQ(left.zones[0].to, 100 * result.resolved.tolerance);
  EXPECT_TRUE(plot.panels[2].zones.empty());  // the point load is not judged
  EXPECT_EQ(*left.y.low, -*left.y.high);
  EXPECT_NE(plot.caption.find("tolerance"), std::string::npos);
}

TEST(ForceDepth, TheUnitsAreThoseAskedFor) {
  Result result = sample::full();
  const Plot atomic = force_depth_plot(result);
  result.resolved.units = Units::laboratory;
  const Plot laboratory = force_depth_plot(result);
  EXPECT_EQ(laboratory.panels[0].x.key, "depth_nm");
  EXPECT_EQ(laboratory.panels[0].y.key, "force_nN");
  const PlotCurve &a = curve(atomic.panels[0], "atoms"), &l = curve(laboratory.panels[0], "atoms");
  EXPECT_DOUBLE_EQ(l.x[3], 0.1 * a.x[3]);
  EXPECT_DOUBLE_EQ(l.y[3], nN_per_eV_per_A * a.y[3]);
  EXPECT_DOUBLE_EQ(*laboratory.panels[2].x.high, 0.1 * *atomic.panels[2].x.high);
}

TEST(ForceDepth, WordsAtTheEndsOfLinesDoNotLieOnEachOther) {
  const Panel panel = force_depth_plot(sample::full()).panels.at(0);
  ASSERT_GE(panel.labels.size(), 2u);
  for (std::size_t i = 1; i < panel.labels.size(); ++i)
    EXPECT_GE(panel.labels[i].y - panel.labels[i - 1].y, 0.05 * *panel.y.high) << panel.labels[i].text;
}

TEST(ForceDepth, OneColumnOfAJournalShowsTheLoadJudged) {
  const Result result = sample::full();
  const Plot plot = narrow_force_depth_plot(result);
  EXPECT_EQ(plot.width, single_column);
  EXPECT_EQ(plot.columns, 1);
  EXPECT_EQ(plot.panels.at(0).title, fmt::format("{} load", result.resolved.judged_load));
}

TEST(WindowScan, EveryLoadInNewtonPerMetreWithTheKnownValueOnce) {
  const Result result = sample::full();
  const Plot plot = window_scan_plot(result);
  ASSERT_EQ(plot.panels.size(), 4u);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_EQ(plot.panels[i].y.key, "Eh_N_per_m");
    EXPECT_EQ(plot.panels[i + 2].y.key, "pretension_N_per_m");
  }
  const std::vector<std::string> all = names(plot.panels[1]);
  EXPECT_EQ(std::ranges::count(all, "known"), 1);
  EXPECT_EQ(std::ranges::count(all, "membrane read by Eq. 16"), 1);  // neither the paper's nor the calibrated one
  const PlotCurve& atoms = curve(plot.panels[0], "atoms read by Eq. 16");
  EXPECT_EQ(atoms.x, result.runs[0].fits[0].scan.depth_max_A);
  EXPECT_DOUBLE_EQ(atoms.y[0], N_per_m_per_eV_per_A2 * result.runs[0].fits[0].scan.Eh_eV_per_A2[0]);
  EXPECT_DOUBLE_EQ(curve(plot.panels[0], "known").y[0], N_per_m_per_eV_per_A2 * result.runs[0].Eh_eV_per_A2);
  EXPECT_TRUE(window_scan_plot(Result{}).panels.empty());
}

TEST(WindowScan, CurvesDifferInGreyToo) {
  std::vector<Marker> markers;
  for (const PlotCurve& one : window_scan_plot(sample::full()).panels.at(0).curves)
    if (one.in_legend) markers.push_back(one.points->marker);
  std::ranges::sort(markers);
  EXPECT_EQ(std::ranges::adjacent_find(markers), markers.end());
}

TEST(WindowScan, DrumsAreInNanometres) {
  Result drum = sample::full();
  for (auto& run : drum.runs)
    for (Fit& fit : run.fits)
      for (double& depth : fit.scan.depth_max_A) depth *= 100;
  const Panel panel = window_scan_plot(drum).panels.at(0);
  EXPECT_EQ(panel.x.key, "depth_max_nm");
  EXPECT_DOUBLE_EQ(curve(panel, "atoms read by Eq. 16").x[0], 0.1 * drum.runs[0].fits[0].scan.depth_max_A[0]);
}

TEST(ExplanationBars, SharesAddUpToTheAtoms) {
  const Result result = sample::full();
  const Plot plot = explanation_plot(result);
  ASSERT_EQ(plot.panels.size(), result.explanations.size());
  ASSERT_FALSE(plot.panels.empty());
  for (const Panel& panel : plot.panels) {
    ASSERT_EQ(panel.bars.size(), shares().size());
    const PlotCurve& atoms = curve(panel, "atoms");
    ASSERT_EQ(atoms.y.size(), panel.x.categories.size());
    EXPECT_LE(atoms.y.size(), 8u);
    for (std::size_t i = 0; i < atoms.y.size(); ++i) {
      double sum = 0;
      for (const StackedBars& bars : panel.bars) sum += std::isfinite(bars.y.at(i)) ? bars.y[i] : 0;
      EXPECT_NEAR(sum, atoms.y[i], 1e-9);
    }
  }
  EXPECT_TRUE(explanation_plot(sample::membrane_only()).panels.empty());
}

}  // namespace

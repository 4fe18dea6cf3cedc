// Figure 1: suspended graphene of the experiment (Lee et al., Science 321 (2008) 385), as the membrane and as
// Eq. 16.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <variant>

#include "compare/base/paper.hpp"
#include "compare/base/units.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/fitting/curve.hpp"
#include "compare/fitting/models/eq16.hpp"
#include "compare/fitting/run_fit.hpp"
#include "compare/fitting/sheet_table.hpp"
#include "membrane/problem.hpp"

namespace validate {
namespace {

namespace lee = paper::suspended;
constexpr double nu = lee::nu, Eh = lee::Eh_eV_per_A2, pretension = lee::pretension_eV_per_A2;
constexpr double nm = 10;  // Å
constexpr int points = 24;

std::vector<double> depths(double a) {
  std::vector<double> d;
  for (int i = 1; i <= points; ++i) d.push_back(0.24 * a * i / points);
  return d;
}

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

/// In nm and nN.
PlotCurve curve_of(const std::string& name, const std::vector<double>& depth_A,
                   const std::vector<double>& force_eV_per_A, Colour colour, std::optional<Line> line) {
  return {.name = name,
          .x = times(depth_A, 1 / nm),
          .y = times(force_eV_per_A, nN_per_eV_per_A),
          .colour = colour,
          .line = line};
}

/// Through the points as comparisons interpolate them.
PlotCurve smooth_curve(const std::string& name, const std::vector<double>& depth_A,
                       const std::vector<double>& force_eV_per_A, Colour colour, Line line) {
  constexpr int pieces = 160;
  const Curve curve(depth_A, force_eV_per_A);
  std::vector<double> depth, force;
  for (int i = 0; i <= pieces; ++i) {
    depth.push_back(std::lerp(curve.lowest_A(), curve.highest_A(), static_cast<double>(i) / pieces));
    force.push_back(curve.at(std::min(depth.back(), curve.highest_A())).value_or(NAN));
  }
  return curve_of(name, depth, force, colour, line);
}

PlotCurve eq16_band(double a) {
  PlotCurve band{.name = fmt::format("Eq. 16, E·h = {:g} ± {:g} N/m", lee::Eh_N_per_m, lee::Eh_spread_N_per_m),
                 .x = {},
                 .y = {},
                 .colour = Colour::grey};
  const double spread = lee::Eh_spread_N_per_m / N_per_m_per_eV_per_A2;
  for (const double d : depths(a)) {
    band.x.push_back(d / nm);
    band.y.push_back(nN_per_eV_per_A * Eq16{a, nu}.force(d, Eh - spread, pretension));
    band.y_high.push_back(nN_per_eV_per_A * Eq16{a, nu}.force(d, Eh + spread, pretension));
  }
  return band;
}

std::vector<double> eq16_forces(double a) {
  std::vector<double> force;
  for (const double d : depths(a)) force.push_back(Eq16{a, nu}.force(d, Eh, pretension));
  return force;
}

double depth_at(const std::vector<double>& depth, const std::vector<double>& force, double wanted_nN) {
  return Curve(force, depth).at(wanted_nN / nN_per_eV_per_A).value_or(NAN) / nm;
}

struct Tip {
  double radius_A;
  bool sphere;
  const char* name;
  Colour colour;
  Line line;
};

/// A point is a disc of 1e-4 of the radius: a finer mesh changes nothing then.
std::vector<Tip> tips(double a) {
  return {{1e-4 * a, false, "membrane, point", Colour::blue, {.width = 2}},
          {lee::tip_A, false, "membrane, disc of 16.5 nm", Colour::vermilion, {.dash = Dash::dashed, .width = 1}},
          {lee::tip_A, true, "membrane, sphere of 16.5 nm", Colour::vermilion, {.width = 2}},
          {lee::wide_tip_A, true, "membrane, sphere of 27.5 nm", Colour::green, {.width = 2}}};
}

struct NamedLaw {
  membrane::Law law;
  const char* name;
  Colour colour;
  Line line;
};

/// Laws that part from St Venant–Kirchhoff's at large strain, under the disc of 16.5 nm.
std::vector<NamedLaw> other_laws() {
  return {{membrane::neo_hookean(Eh, nu), "neo-Hookean, disc of 16.5 nm", Colour::purple, {.dash = Dash::long_dashed}},
          {membrane::LeeGraphene{Eh, nu},
           "Lee et al.'s softening law, disc of 16.5 nm",
           Colour::orange,
           {.dash = Dash::dash_dotted}}};
}

/// A nodal force on the paper's mesh: 44 equal rings, 1936 triangles on the quarter. Forces at the given
/// depths.
std::vector<double> paper_mesh_forces(double a) {
  membrane::Problem problem;
  problem.sheet = membrane::paper_disc(a);
  problem.law = membrane::StVenantKirchhoff{Eh, nu};
  problem.prestress_eV_per_A2 = pretension * Eigen::Matrix2d::Identity();
  problem.load = membrane::PointLoad{};
  problem.levels = depths(a);
  std::vector<double> force;
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    if (step.converged) force.push_back(step.force_eV_per_A);
    return step.converged;
  });
  if (!report.converged) throw std::runtime_error("figure 1, the paper's mesh: " + report.reason);
  return force;
}

void compare_with_experiment(PaperFigure& figure, double a, const Tip& tip, const std::vector<double>& force) {
  const auto found = fit_computed(force_model(any_model(Eq16{a, nu})), a, depths(a), force);
  const auto* fit = std::get_if<Fit>(&found);
  if (!fit) return;
  const std::string where = fmt::format("a = {:g} µm, Eq. 16 fitted to {}", a / 1e4, tip.name);
  const std::string source = "Lee et al. 2008, averages";
  figure.numbers.push_back({where + ": E·h", "N/m", source, lee::Eh_N_per_m, fit->Eh_eV_per_A2 * N_per_m_per_eV_per_A2,
                            0, "the membrane has 342 N/m; a tip of finite size is read as a stiffer sheet"});
  figure.numbers.push_back({where + ": pretension", "N/m", source, lee::pretension_N_per_m,
                            fit->pretension_eV_per_A2 * N_per_m_per_eV_per_A2, 0,
                            "the membrane has 0.34 N/m; Eq. 16's pretension term is too large for any small tip"});
}

Panel panel(double a, PaperFigure& figure, const FigureContext& context) {
  Panel panel{.title = fmt::format("a = {:g} µm", a / 1e4),
              .x = {.label = "depth", .unit = "nm", .key = "depth_nm", .low = 0},
              .y = {.label = "force", .unit = "nN", .key = "force_nN", .low = 0},
              .legend = Legend::left_top};
  panel.curves.push_back(eq16_band(a));
  panel.curves.push_back(smooth_curve("Eq. 16, averages", depths(a), eq16_forces(a), Colour::black, {.width = 1}));
  const double reference_nm[] = {103.37, 97.58};
  std::vector<double> converged;  // of the point load
  int index = 0;
  for (const Tip& tip : tips(a)) {
    context.progress.say(fmt::format("figure 1: {}, a = {:g} µm", tip.name, a / 1e4));
    const std::vector<double> force = membrane_forces({a, nu, tip.radius_A, 0, tip.sphere}, Eh, pretension, depths(a));
    panel.curves.push_back(smooth_curve(tip.name, depths(a), force, tip.colour, tip.line));
    if (a == lee::radius_A && index < 2)
      figure.numbers.push_back({fmt::format("a = 0.5 µm, {}: depth at 1500 nN", tip.name), "nm",
                                "one-dimensional solver written separately", reference_nm[index],
                                depth_at(depths(a), force, 1500), 1e-3, ""});
    if (index++ == 0) converged = force;
    compare_with_experiment(figure, a, tip, force);
  }
  const std::vector<double> coarse = paper_mesh_forces(a);
  panel.curves.push_back(
      curve_of("membrane, point, the paper's 1936 triangles", depths(a), coarse, Colour::blue, std::nullopt));
  panel.curves.back().points = Points{.marker = Marker::square, .open = true};
  if (a == lee::radius_A)
    figure.numbers.push_back({"a = 0.5 µm, point on the paper's 1936 triangles: depth at 1500 nN", "nm",
                              "the converged membrane", depth_at(depths(a), converged, 1500),
                              depth_at(depths(a), coarse, 1500), 0,
                              "a nodal force on equal rings has a tip of about one element: too stiff by "
                              "some per cent, whatever the "
                              "mesh-convergence study says"});
  for (const NamedLaw& other : other_laws()) {
    const SheetCurve curve = sheet_curve({a, nu, lee::tip_A, 0, false}, other.law, pretension, depths(a));
    if (!curve.ended_early.empty())
      context.progress.say(fmt::format("figure 1: {} ends at {:.3g} nm: {}", other.name,
                                       curve.depth_A.empty() ? 0 : curve.depth_A.back() / nm, curve.ended_early));
    if (curve.depth_A.size() > 1)
      panel.curves.push_back(smooth_curve(other.name, curve.depth_A, curve.force_eV_per_A, other.colour, other.line));
  }
  if (a == lee::radius_A)
    figure.numbers.push_back({"a = 0.5 µm, Eq. 16: depth at 1500 nN", "nm", "the formula itself", 102.64,
                              depth_at(depths(a), eq16_forces(a), 1500), 1e-3, ""});
  return panel;
}

/// Every curve over Eq. 16 with the experiment's averages: nine of them lie within one band of forces.
Panel residuals(double a, Panel& forces) {
  Panel panel{.title = {},
              .x = forces.x,
              .y = {.label = "over Eq. 16", .unit = "%", .key = "difference_percent", .low = -40, .high = 60},
              .legend = Legend::right_top,
              .marks = {{.along = Along::y, .at = 0}}};
  const auto difference = [a](double depth_nm, double force_nN) {
    const double closed_form = nN_per_eV_per_A * Eq16{a, nu}.force(nm * depth_nm, Eh, pretension);
    return 100 * (force_nN / closed_form - 1);
  };
  std::size_t named = 0;  // a legend of six above, of the others here
  for (PlotCurve& curve : forces.curves) {
    PlotCurve residual = curve;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      residual.y[i] = difference(curve.x[i], curve.y[i]);
      if (!curve.y_high.empty()) residual.y_high[i] = difference(curve.x[i], curve.y_high[i]);
    }
    curve.in_legend = named < 6;
    residual.in_legend = named++ >= 6;
    panel.curves.push_back(std::move(residual));
  }
  return panel;
}

}  // namespace

PaperFigure figure1(const FigureContext& context) {
  PaperFigure figure;
  figure.number = 1;
  figure.title = "suspended graphene, E·h = 342 N/m, pretension 0.34 N/m, nu = 0.165";
  std::vector<Panel> below;
  for (const double a : {lee::radius_A, lee::wide_radius_A}) {
    figure.panels.push_back(panel(a, figure, context));
    below.push_back(residuals(a, figure.panels.back()));
  }
  for (Panel& one : below) figure.panels.push_back(std::move(one));
  figure.row_shares = {0.6, 0.4};
  return figure;
}

}  // namespace validate

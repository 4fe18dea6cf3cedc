// Figure 2: a sheet of 110 Å as atoms, membrane, plates and Eq. 16.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "compare/base/errors.hpp"
#include "compare/base/paper.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/units.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/fitting/curve.hpp"
#include "compare/fitting/models/eq16.hpp"
#include "compare/fitting/models/foeppl.hpp"
#include "compare/fitting/sheet_table.hpp"
#include "compare/input/case_file.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/process/atoms.hpp"
#include "compare/study/study.hpp"
#include "compare/verdict/agreement.hpp"

namespace validate {
namespace {

using paper::radius_A, paper::tip_A;
// Duan & Wang's thickness for a plate of the card's E·h (the paper's reference [47]).
constexpr double duan_wang_thickness_A = 0.52;

std::vector<double> plate_depths() {
  std::vector<double> d;
  for (int i = 1; i <= 24; ++i) d.push_back(i);
  return d;
}

/// Clamped von Kármán plate: force at each depth.
std::vector<double> plate(double a, double Eh, double nu, double bending_eV, double tip) {
  std::vector<double> force;
  const FoepplDisc disc{nu, tip / a, bending_eV / (Eh * a * a)};
  for (const double d : plate_depths()) force.push_back(Eh * a * force_at(disc, d / a, 0));
  return force;
}

StudyOutcome study(const std::string& potential, const FigureContext& context) {
  Case c;
  read_case(inputs_folder() / "indentation.toml", c);
  c.potential = potential;
  c.radius_A = radius_A;
  c.tip_radius_A = tip_A;
  const std::optional<PotentialFile> file = read_potential(potential, inputs_folder() / "potentials", "--potential");
  const std::filesystem::path folder = context.work / std::filesystem::path(potential).stem();
  std::filesystem::create_directories(folder / "work");
  const AtomsLaunch launch{.program = atoms_program(), .launcher = {}, .cores = available_cores()};
  StudyOutcome outcome = run_study(Command::indentation, c, file, {launch, 0, folder}, context.progress);
  if (!outcome.failure.empty()) throw Error(ExitCode::atomistic_failed, outcome.failure);
  return outcome;
}

PlotCurve curve_of(const Run& run, const std::string& name, Colour colour, std::optional<Line> line) {
  PlotCurve curve{.name = name, .x = {}, .y = {}, .colour = colour, .line = line};
  for (const std::size_t i : usable_points(run)) {
    curve.x.push_back(run.depth_A[i]);
    curve.y.push_back(run.force_eV_per_A[i]);
  }
  return curve;
}

void add_runs(Panel& point, Panel& disc, const Result& result, const std::string& potential, Colour colour,
              bool first) {
  for (const Run& run : result.runs) {
    std::vector<PlotCurve>& curves = (run.load == LoadKind::point ? point : disc).curves;
    if (run.model == Model::atomistic)
      curves.push_back(curve_of(run, potential + ", atoms", colour, std::nullopt));
    else if (run.constants == Constants::card)
      curves.push_back(curve_of(run, potential + ", membrane", colour, Line{}));
    else if (run.model == Model::sheet)
      curves.push_back(curve_of(run, potential + ", sheet of its own law", colour, Line{Dash::dotted, 1.2}));
    else if (first && run.constants == Constants::paper)
      curves.push_back(curve_of(run, "membrane, the paper's constants", Colour::black, Line{Dash::dashed, 2}));
  }
}

void add_ratios(Panel& point, Panel& disc, const Result& result, const std::string& potential, Colour colour) {
  for (const Comparison& c : result.comparisons) {
    PlotCurve curve{.name = potential, .x = {}, .y = {}, .colour = colour};
    curve.line = Line{.width = 1.2};
    curve.points = Points{.size = 0.6};
    for (std::size_t i = 0; i < c.depth_A.size(); ++i) {
      if (c.regime[i] == Regime::artefact) continue;
      curve.x.push_back(c.depth_relative[i]);
      curve.y.push_back(c.force_ratio[i]);
    }
    (c.load == LoadKind::point ? point : disc).curves.push_back(std::move(curve));
  }
}

void add_plates(Panel& panel, const Result& result, double tip) {
  const auto add = [&](const std::string& name, const std::vector<double>& force, Colour colour, Line line) {
    panel.curves.push_back({.name = name, .x = plate_depths(), .y = force, .colour = colour, .line = line});
  };
  const CardSummary& card = *result.card;
  const double a = result.sheet->effective_radius_A;
  const double thin = card.Eh_eV_per_A2 * std::pow(duan_wang_thickness_A, 2) / (12 * (1 - card.nu * card.nu));
  add("plate, card's κ", plate(a, card.Eh_eV_per_A2, card.nu, card.bending_modulus_eV, tip), Colour::dark_grey,
      {Dash::dotted, 1.2});
  add("plate, h = 0.52 Å", plate(a, card.Eh_eV_per_A2, card.nu, thin, tip), Colour::dark_grey,
      {Dash::long_dashed, 1.2});
  add("shell of [30], κ = 1.30 eV", plate(radius_A, paper::Eh_eV_per_A2, paper::nu, paper::shell_bending_eV, tip),
      Colour::grey, {Dash::dash_dotted, 1.2});
  std::vector<double> eq16;
  for (const double d : plate_depths()) eq16.push_back(Eq16{radius_A, paper::nu}.force(d, paper::Eh_eV_per_A2, 0));
  add("Eq. 16, the paper's constants", eq16, Colour::black, {.width = 0.8});
}

void add_numbers(PaperFigure& figure) {
  constexpr double force = 20;  // eV/Å
  const std::string separate = "one-dimensional solver written separately";
  const auto depth = [&](double tip) {
    std::vector<double> d;
    for (int i = 1; i <= 40; ++i) d.push_back(0.85 * i);
    return Curve(membrane_forces({radius_A, paper::nu, tip, 0}, paper::Eh_eV_per_A2, 0, d), d).at(force).value_or(NAN);
  };
  figure.numbers.push_back(
      {"membrane, paper's constants, point: depth at 20 eV/Å", "Å", separate, 31.62, depth(0), 1e-3, ""});
  figure.numbers.push_back(
      {"membrane, paper's constants, disc of 10 Å: depth at 20 eV/Å", "Å", separate, 28.113, depth(tip_A), 1e-3, ""});
  std::vector<double> d, eq16;
  for (int i = 1; i <= 400; ++i) {
    d.push_back(0.1 * i);
    eq16.push_back(Eq16{radius_A, paper::nu}.force(d.back(), paper::Eh_eV_per_A2, 0));
  }
  figure.numbers.push_back({"Eq. 16, paper's constants: depth at 20 eV/Å", "Å", "the formula itself", 31.604,
                            Curve(eq16, d).at(force).value_or(NAN), 1e-4, ""});
}

void add_moduli(PaperFigure& figure, const Result& result, const std::string& potential) {
  figure.numbers.push_back({potential + ": E·h", "N/m", "Gil et al. 2010 (from their reference [30])",
                            paper::Eh_eV_per_A2 * N_per_m_per_eV_per_A2,
                            result.card->Eh_eV_per_A2 * N_per_m_per_eV_per_A2, 0,
                            "the paper's constants were fitted to an older molecular-mechanics curve"});
}

Panel force_panel(const char* title) {
  return {.title = title,
          .x = {.label = "depth", .unit = "Å", .key = "depth_A", .low = 0, .high = 25},
          .y = {.label = "force", .unit = "eV/Å", .key = "force_eV_per_A", .low = 0},
          .legend = Legend::left_top};
}

Panel ratio_panel(const std::string& load) {
  return {.title = "atoms over membrane, " + load,
          .x = {.label = "depth / effective radius", .unit = {}, .key = "depth_relative", .low = 0, .high = 0.25},
          .y = {.label = "force ratio", .unit = {}, .key = "force_ratio", .low = 0.8, .high = 1.5},
          .legend = Legend::right_top,
          .marks = {{.along = Along::y, .at = 1}}};
}

}  // namespace

PaperFigure figure2(const FigureContext& context) {
  PaperFigure figure;
  figure.number = 2;
  figure.title = "a sheet of R = 110 Å: atoms, membrane, plates, Eq. 16";
  Panel point = force_panel("point load"), disc = force_panel("disc of 10 Å");
  Panel point_ratio = ratio_panel("point"), disc_ratio = ratio_panel("disc");
  for (std::size_t i = 0; i < context.potentials.size(); ++i) {
    const std::string& potential = context.potentials[i];
    const std::string name = std::filesystem::path(potential).stem().string();
    const StudyOutcome outcome = study(potential, context);
    add_runs(point, disc, outcome.result, name, nth_colour(i), i == 0);
    add_ratios(point_ratio, disc_ratio, outcome.result, name, nth_colour(i));
    add_moduli(figure, outcome.result, name);
    if (i == 0) {
      add_plates(point, outcome.result, 0);
      add_plates(disc, outcome.result, tip_A);
    }
  }
  add_numbers(figure);
  figure.panels = {point, disc, point_ratio, disc_ratio};
  return figure;
}

}  // namespace validate

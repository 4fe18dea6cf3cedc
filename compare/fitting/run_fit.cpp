#include "compare/fitting/run_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <new>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include "compare/fitting/curve.hpp"
#include "compare/fitting/fit.hpp"
#include "compare/fitting/fit_warnings.hpp"
#include "compare/fitting/models/eq16.hpp"

namespace validate {
namespace {

AnyCurveModel curve_model(const ForceModel& model) {
  return {2, [&model](double d, std::span<const double> p) { return model.at(d, p[0], p[1]).force; },
          [&model](double d, std::span<const double> p, std::span<double> g) {
            const ForceAt at = model.at(d, p[0], p[1]);
            g[0] = at.by_Eh;
            g[1] = at.by_pretension;
          }};
}

LeastSquaresReport solved(const ForceModel& model, const std::vector<double>& depth, const std::vector<double>& force) {
  const auto deepest = static_cast<std::size_t>(std::ranges::max_element(depth) - depth.begin());
  const double typical = model.typical_Eh, untensioned = model.at(depth[deepest], typical, 0).force;
  const double start[] = {typical * force[deepest] / untensioned, 0};
  return least_squares(curve_model(model), depth, force, start, {.geodesic_acceleration = true});
}

/// A sheet that is larger by `more`: F(d; a) = E·h a f(d/a), at the same tip over a.
ForceModel larger(const ForceModel& model, double a, double more) {
  const double ratio = (a + more) / a;
  const ForceModel stronger = scaled(model, ratio);
  return with_forces(model,
                     [at = stronger.at, ratio](double d, double Eh, double N0) { return at(d / ratio, Eh, N0); });
}

/// Forces multiplied by 1 + error at no depth and 1 − error at the deepest.
ForceModel tilted(const ForceModel& model, double error, double deepest) {
  return with_forces(model, [at = model.at, error, deepest](double d, double Eh, double N0) {
    const double factor = 1 + error * (1 - 2 * d / deepest);
    const ForceAt f = at(d, Eh, N0);
    return ForceAt{factor * f.force, factor * f.by_Eh, factor * f.by_pretension};
  });
}

/// What a fit changes by where the model is another.
ErrorSource shift(std::string name, const ForceModel& other, const std::vector<double>& depth,
                  const std::vector<double>& force, const LeastSquaresReport& from) {
  const LeastSquaresReport to = solved(other, depth, force);
  if (!to.converged) return {std::move(name), not_known, not_known};
  return {std::move(name), std::abs(to.parameters[0] - from.parameters[0]),
          std::abs(to.parameters[1] - from.parameters[1])};
}

void add_errors(Fit& fit) {
  double Eh2 = 0, pretension2 = 0;
  for (const ErrorSource& source : fit.sources) {
    Eh2 += std::pow(source.Eh_eV_per_A2, 2);
    pretension2 += std::pow(source.pretension_eV_per_A2, 2);
  }
  constexpr double coverage = 1.96;  // 95 % of a normal error
  fit.Eh_stderr_eV_per_A2 = std::sqrt(Eh2);
  fit.pretension_stderr_eV_per_A2 = std::sqrt(pretension2);
  const auto around = [](double value, double error) {
    return std::array{value - coverage * error, value + coverage * error};
  };
  fit.Eh_interval_eV_per_A2 = around(fit.Eh_eV_per_A2, fit.Eh_stderr_eV_per_A2);
  fit.pretension_interval_eV_per_A2 = around(fit.pretension_eV_per_A2, fit.pretension_stderr_eV_per_A2);
  std::ranges::sort(fit.sources, std::greater{}, &ErrorSource::Eh_eV_per_A2);
}

}  // namespace

std::variant<Fit, std::string> fit_computed(const ForceModel& model, double a, const std::vector<double>& depth,
                                            const std::vector<double>& force, const ComputedInputs& inputs) {
  const LeastSquaresReport report = solved(model, depth, force);
  if (!report.converged) return report.reason;
  Fit fit;
  fit.Eh_eV_per_A2 = report.parameters[0];
  fit.pretension_eV_per_A2 = report.parameters[1];
  fit.correlation = report.correlation(0, 1);
  const double numerical = std::hypot(inputs.force_error_relative, model.relative_error);
  // A numerical error may be that of all forces, or one way at the shallow end and the other at the deep one.
  const ErrorSource level = shift("numerical", scaled(model, 1 + numerical), depth, force, report);
  const ErrorSource tilt = shift("", tilted(model, numerical, std::ranges::max(depth)), depth, force, report);
  fit.sources.push_back({level.name, std::hypot(level.Eh_eV_per_A2, tilt.Eh_eV_per_A2),
                         std::hypot(level.pretension_eV_per_A2, tilt.pretension_eV_per_A2)});
  if (inputs.radius_error_A > 0)
    fit.sources.push_back(shift("clamp radius", larger(model, a, inputs.radius_error_A), depth, force, report));
  add_errors(fit);
  fit.rms_relative = rms(report.residuals) / std::ranges::max(force);
  fit.window_A = {std::ranges::min(depth), std::ranges::max(depth)};
  fit.points = static_cast<int>(depth.size());
  fit.fitted_depth_A = depth;
  fit.residual_eV_per_A = report.residuals;
  for (std::size_t i = 0; i < force.size(); ++i) fit.model_force_eV_per_A.push_back(force[i] - report.residuals[i]);
  fit.scan = scan_window(model, depth, force);
  return fit;
}

WindowScan scan_window(const ForceModel& model, const std::vector<double>& depth, const std::vector<double>& force) {
  std::vector<std::size_t> order(depth.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return depth[i]; });
  WindowScan scan;
  std::vector<double> d, f;
  for (const std::size_t i : order) {
    d.push_back(depth[i]);
    f.push_back(force[i]);
    if (d.size() < fewest_points_to_fit) continue;
    const LeastSquaresReport report = solved(model, d, f);
    if (!report.converged) continue;
    scan.depth_max_A.push_back(depth[i]);
    scan.Eh_eV_per_A2.push_back(report.parameters[0]);
    scan.pretension_eV_per_A2.push_back(report.parameters[1]);
  }
  return scan;
}

namespace {

struct Points {
  std::vector<double> depth, force;
};

Points usable(const Run& run) {
  Points points;
  for (const std::size_t i : usable_points(run)) {
    points.depth.push_back(run.depth_A[i]);
    points.force.push_back(run.force_eV_per_A[i]);
  }
  return points;
}

std::string too_few(const Run& run, std::size_t count) {
  std::size_t artefacts = 0, unconverged = 0;
  if (run.is_atomistic()) artefacts = static_cast<std::size_t>(std::ranges::count(run.atoms().artefact, true));
  for (const bool flag : run.converged) unconverged += !flag;
  return fmt::format("{} usable points of {} ({} in the artefact zone, {} not converged); a fit needs {}", count,
                     run.depth_A.size(), artefacts, unconverged, fewest_points_to_fit);
}

/// One model of the ladder.
struct Rung {
  std::string name;
  ForceModel model;
};

/// Tables, each made once for all curves of one sheet, tip and law.
class Tables {
 public:
  explicit Tables(const std::vector<Run>& runs) {
    for (const Run& run : runs)
      for (const std::size_t i : usable_points(run))
        deepest_[place(run)] = std::max(deepest_[place(run)], run.depth_A[i]);
  }

  /// Throws std::runtime_error where the sheet is not solved.
  const ForceModel& of(const Run& run, const std::optional<SheetPhysics>& physics) {
    const auto key = std::pair(place(run), physics ? physics->model : fitted_membrane);
    if (const auto found = made_.find(key); found != made_.end()) return found->second;
    MembraneTip tip{run.a_A, run.nu, run.tip_A, run.record_radius_A, run.load == LoadKind::sphere, physics};
    constexpr double softening = 1e-2;  // of E·h: a pretension that softening is mistaken for
    const double share = std::max(run.pretension_eV_per_A2 / run.Eh_eV_per_A2, 0.0);
    return made_[key] =
               sheet_table(tip, {deepest_[place(run)], run.Eh_eV_per_A2,
                                 2 * share + (physics && physics->model == fitted_sheet ? softening / 10 : softening)});
  }

 private:
  using Place = std::tuple<LoadKind, double, double, double, double, double, double>;
  static Place place(const Run& r) {
    return {r.load, r.a_A, r.tip_A, r.record_radius_A, r.nu, r.Eh_eV_per_A2, r.pretension_eV_per_A2};
  }
  std::map<Place, double> deepest_;
  std::map<std::pair<Place, std::string>, ForceModel> made_;
};

/// The models for a run; those that cannot be tabulated are left out.
std::vector<Rung> rungs(const Run& run, const LadderPhysics& physics, double deepest, Tables& tables) {
  std::vector<Rung> found = {{"eq16", force_model(any_model(Eq16{run.a_A, run.nu}))}};
  const auto add = [&](const char* name, const std::optional<SheetPhysics>& of) {
    try {
      found.push_back({name, tables.of(run, of)});
    } catch (const std::bad_alloc&) {  // another time it would be
      throw;
    } catch (const std::exception&) {  // it is not solved: the ladder does without it
    }
  };
  add(fitted_membrane, std::nullopt);
  if (!run.is_atomistic() && run.constants != Constants::calibrated) return found;
  if (physics.sheet) add(fitted_sheet, physics.sheet);
  // A law of third order may end long before: it then has no place among fits at the same depths.
  if (physics.third_order) {
    const double others = found.back().model.deepest_A;
    add(fitted_third_order, physics.third_order);
    if (found.back().name == fitted_third_order) {
      if (found.back().model.deepest_A < 0.98 * std::min(others, deepest))
        found.pop_back();
      else if (physics.sheet)
        std::swap(found.back(), found[found.size() - 2]);
    }
  }
  return found;
}

void keep_up_to(Points& points, double deepest) {
  Points kept;
  for (std::size_t i = 0; i < points.depth.size(); ++i) {
    if (points.depth[i] > deepest) continue;
    kept.depth.push_back(points.depth[i]);
    kept.force.push_back(points.force[i]);
  }
  points = std::move(kept);
}

ComputedInputs inputs_of(const Result& result, const Run& run) {
  ComputedInputs inputs;
  if (!run.is_atomistic() || !result.sheet) return inputs;
  inputs.radius_error_A = result.sheet->clamp_radius_error_A;
  for (const double e : run.atoms().force_error_relative)
    if (std::isfinite(e)) inputs.force_error_relative = std::max(inputs.force_error_relative, e);
  return inputs;
}

void fit_run(Run& run, const LadderPhysics& physics, const ComputedInputs& inputs, Tables& tables) {
  run.fits.clear();
  run.fit_skipped.clear();
  run.models_skipped.clear();
  if (run.load == LoadKind::pressure) {
    run.fit_skipped = "the models are of an indenter, not of a pressure";
    return;
  }
  if (std::isfinite(run.rim_tension_eV_per_A2)) {
    run.fit_skipped = "the models are of a clamped rim, not of one that is pulled";
    return;
  }
  Points points = usable(run);
  if (points.depth.size() < fewest_points_to_fit) {
    run.fit_skipped = too_few(run, points.depth.size());
    return;
  }
  if (!(std::isfinite(Eq16{run.a_A, run.nu}.q()) && run.a_A > 0)) {
    run.fit_skipped = fmt::format("radius {} Å and Poisson's ratio {} give no Eq. 16", run.a_A, run.nu);
    return;
  }
  const double deepest = std::ranges::max(points.depth);
  const std::vector<Rung> ladder = rungs(run, physics, deepest, tables);
  double common = deepest;
  for (const Rung& rung : ladder) common = std::min(common, rung.model.deepest_A * (1 + 1e-9));
  keep_up_to(points, common);
  if (points.depth.size() < fewest_points_to_fit) {
    run.fit_skipped = fmt::format("the law ends at {:.4g} Å, before the fourth point", common);
    return;
  }
  for (const Rung& rung : ladder) {
    auto found = fit_computed(rung.model, run.a_A, points.depth, points.force, inputs);
    if (auto* fit = std::get_if<Fit>(&found)) {
      fit->model = rung.name;
      if (common < deepest) fit->torn_at_A = common;
      run.fits.push_back(std::move(*fit));
    } else {
      run.models_skipped.push_back(fmt::format("{}: {}", rung.name, std::get<1>(found)));
    }
  }
  if (run.fits.empty())
    run.fit_skipped = fmt::format("{}", fmt::join(run.models_skipped, "; "));
  else
    run.fits.back().recommended = true;
}

/// The plain membrane of the card's constants under the same load.
const Run* like_for_like(const Result& result, const Run& run) {
  const auto twin = std::ranges::find_if(result.runs, [&](const Run& other) {
    return other.model == Model::membrane && other.constants == Constants::card && other.load == run.load;
  });
  return twin == result.runs.end() ? nullptr : &*twin;
}

/// What Eq. 16 reads from a membrane at the depths of a fit, as far as it reaches.
std::optional<FitBias> bias_of(const Fit& fit, const Run& membrane) {
  try {
    const Curve curve(membrane);
    std::vector<double> depth, force;
    for (const double d : fit.fitted_depth_A) {
      const auto f = curve.at(d);
      if (!f) continue;
      depth.push_back(d);
      force.push_back(*f);
    }
    if (depth.size() < fewest_points_to_fit || depth.size() < fit.fitted_depth_A.size() / 2) return std::nullopt;
    const LeastSquaresReport read = solved(force_model(any_model(Eq16{membrane.a_A, membrane.nu})), depth, force);
    if (read.converged)
      return FitBias{membrane.Eh_eV_per_A2, read.parameters[0], membrane.pretension_eV_per_A2, read.parameters[1]};
  } catch (const std::invalid_argument&) {  // no curve
  }
  return std::nullopt;
}

}  // namespace

void fit_runs(Result& result, const LadderPhysics& physics) {
  std::map<LoadKind, std::vector<Run*>> loads;
  for (Run& run : result.runs) loads[run.load].push_back(&run);
  std::map<LoadKind, std::exception_ptr> failures;
  for (const auto& [load, runs] : loads) failures[load] = nullptr;
  {
    std::vector<std::jthread> threads;  // a load each: their tables have nothing in common
    for (auto& [load, runs] : loads)
      threads.emplace_back([&result, &physics, &runs = runs, &failure = failures[load]] {
        try {
          Tables tables(result.runs);
          for (Run* run : runs) fit_run(*run, physics, inputs_of(result, *run), tables);
        } catch (...) {
          failure = std::current_exception();
        }
      });
  }
  for (const auto& [load, failure] : failures)
    if (failure) std::rethrow_exception(failure);
}

void fit_run(Run& run, const LadderPhysics& physics, const ComputedInputs& inputs) {
  Tables tables({run});
  fit_run(run, physics, inputs, tables);
}

std::optional<Eq16Reading> read_by_eq16(const Run& run, const std::vector<double>& depth,
                                        const std::vector<double>& force) {
  if (depth.size() < fewest_points_to_fit || run.load == LoadKind::pressure) return std::nullopt;
  const LeastSquaresReport read = solved(force_model(any_model(Eq16{run.a_A, run.nu})), depth, force);
  if (!read.converged) return std::nullopt;
  return Eq16Reading{read.parameters[0], read.parameters[1]};
}

void add_biases(Result& result) {
  for (Run& run : result.runs) {
    Fit* fit = closed_form_fit(run.fits);
    const Run* membrane = fit ? like_for_like(result, run) : nullptr;
    if (membrane) fit->bias = bias_of(*fit, *membrane);
  }
  add_warnings(result);
}

}  // namespace validate

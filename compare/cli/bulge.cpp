#include "compare/cli/bulge.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/progress.hpp"
#include "compare/base/toml_file.hpp"
#include "compare/cli/atoms_options.hpp"
#include "compare/cli/flags.hpp"
#include "compare/documents/atoms_files.hpp"
#include "compare/documents/bulge_result.hpp"
#include "compare/documents/texts/summary_json.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/process/provenance.hpp"
#include "compare/process/run_folder.hpp"

namespace validate {
namespace {

/// Names the atoms' folder and files.
const std::string atoms_load = "pressure";

constexpr const char* bulge_examples =
    R"(The default is Figure 4 of Gil et al. 2010: a square whose edges slide in their plane, wrinkled along every side.

Examples:
  validate bulge
  validate bulge --extent full --cells 60
  validate bulge --shape disc --size "1 um" --edge clamped --E "1.0209 TPa" --thickness "0.335 nm" --nu 0.165 \
      --pretension "0.34 N/m" --pressures "0.1 MPa,1 MPa"
  validate bulge --unrelaxed     # what the sheet does if it could bear compression
  validate bulge --potential tersoff --shape disc --edge clamped --size 100 --pressures 1e-3,4e-3    # atoms beside it)";

/// The membrane's path; record of each step's fields and depth.
void solve_membrane(const membrane::Problem& problem, BulgeResult& result, Progress& progress) {
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    result.pictures.push_back(picture_of(problem, step, result.resolved.thickness_A));
    result.points.push_back(bulge_point(step, result.pictures.back()));
    progress.say(fmt::format("membrane  {}/{}  pressure {:.5g} eV/Å³  centre {:.3f} Å  {} Newton steps", step.level + 1,
                             problem.levels.size(), step.pressure_eV_per_A3, step.depth_A, step.newton_iterations));
    return !interrupted();
  });
  result.converged = report.converged;
  result.ended_reason = report.reason;
  result.triangles = report.triangles;
  result.factorisations = report.factorisations;
}

/// The membrane with the potential's constants, then the atoms. What failed of the atoms is returned, the membrane
/// kept.
AtomsCurve solve_pair(const BulgePair& pair, const AtomsLaunch& launch, int ranks, const RunFolder& folder,
                      BulgeResult& result, Progress& progress) {
  solve_membrane(pair.membrane, result, progress);
  const int useful = ranks > 0 ? ranks : useful_ranks(launch, pair.sheet.atoms(), 1);
  progress.say(fmt::format("{} atoms, {} rank(s)", pair.sheet.atoms(), useful));
  const AtomsCurve curve = compute_curves(launch, {{atoms_load, pair.atoms}}, useful, folder.work(), progress)[0];
  std::vector<double> depths;
  for (const BulgePoint& point : result.points) depths.push_back(point.depth_A);
  result.atoms = bulge_atoms(pair, curve, depths, result.pictures);
  result.provenance.lammps = curve.lammps;
  write_lammps_log(folder.work(), folder.drafts());
  write_deepest_sheet(pair.atoms.potential, atoms_load, pair.sheet, folder.work(), folder.drafts());
  return curve;
}

void write_document(const BulgeResult& result, const std::string& target) {
  const std::string text = bulge_document(result).dump(1) + "\n";
  if (target == "-")
    fmt::print("{}", text);
  else
    write_file(target, text);
}

struct Asked {
  BulgeCase c;
  std::optional<PotentialFile> potential;
};

Asked asked(const CLI::App& command, const RunOptions& options) {
  Asked a;
  Origins origins = TomlFile(options.case_file.value_or(inputs_folder() / "figure4.toml"), "--case").read(a.c);
  apply_flags(command, a.c, origins);
  check(a.c, origins);
  if (a.c.potential.empty()) return a;
  a.potential = read_potential(a.c.potential, inputs_folder() / "potentials", label_of(origins, "potential"));
  for (const std::string& warning : a.potential->warnings) spdlog::warn("{}", warning);
  return a;
}

nlohmann::ordered_json identity_of(const Asked& a) {
  nlohmann::ordered_json identity = bulge_case_document(a.c);
  if (a.potential) identity["potential_definition"] = definition_of(*a.potential);
  return identity;
}

ExitCode exit_code_of(const BulgeResult& result) {
  const bool atoms_lost = result.atoms && result.atoms->ended == Ended::not_converged;
  return result.converged && !atoms_lost ? ExitCode::success : ExitCode::not_converged;
}

/// Everything that is computed; what failed of the atoms.
AtomsCurve solve(const Asked& a, const RunOptions& options, const RunFolder& folder, BulgeResult& result,
                 Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  result.resolved = a.c;
  result.provenance = provenance(command_line());
  AtomsCurve curve;
  if (a.potential) {
    const AtomsLaunch launch = launch_of(options);
    const PotentialCard card = potential_card(*a.potential, launch, card_cache(), false);
    result.resolved.E_eV_per_A3 = card.card.sheet_modulus_eV_per_A2() / a.c.thickness_A;
    result.resolved.nu = card.card.nu();
    result.provenance.potential_file = a.potential->potential.file;
    result.provenance.potential_sha256 = a.potential->sha256;
    curve = solve_pair(pair_bulge(a.c, card), launch, options.ranks, folder, result, progress);
  } else {
    solve_membrane(bulge_problem(a.c), result, progress);
  }
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return curve;
}

int bulge(const CLI::App& command, const RunOptions& options) {
  check(options);
  const Asked a = asked(command, options);
  if (options.dry_run) {
    fmt::print("{}\n", bulge_case_document(a.c).dump(1));
    return 0;
  }
  atomistic::use_one_math_thread();
  catch_interrupts();
  if (options.json) check_json_target(options.json->string());
  const std::string name = a.potential ? fmt::format("-{}", std::filesystem::path(a.c.potential).stem().string()) : "";
  RunFolder folder(options, fmt::format("bulge{}-{}-{:g}", name, a.c.shape, a.c.size_A), identity_of(a));
  Progress progress(options.quiet);
  BulgeResult result;
  AtomsCurve curve;
  try {
    curve = solve(a, options, folder, result, progress);
  } catch (const std::exception&) {
    folder.remove_if_unused();
    throw;
  }
  write_bulge(result, folder.drafts());
  folder.publish();
  if (!options.json || *options.json != "-") fmt::print("{}", bulge_table(result));
  if (options.json) write_document(result, options.json->string());
  if (!curve.failure.empty()) throw Error(curve.failure_code, curve.failure);
  folder.finish(interrupted() ? ExitCode::interrupted : exit_code_of(result));
  progress.say(fmt::format("wrote {}", folder.path().string()));
  if (interrupted()) throw Error(ExitCode::interrupted, "interrupted; the pressures so far are written");
  return static_cast<int>(exit_code_of(result));
}

}  // namespace

void add_bulge(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("bulge", "a wrinkling membrane under follower pressure, and atoms beside it");
  add_flags<BulgeCase>(*command);
  const auto options = std::make_shared<RunOptions>();
  add_run_options(*command, *options);
  command->footer(bulge_examples);
  command->callback([command, options, &exit_code] { exit_code = bulge(*command, *options); });
}

}  // namespace validate

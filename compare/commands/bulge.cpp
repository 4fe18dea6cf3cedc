#include "compare/commands/bulge.hpp"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <memory>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/bulge/bulge_result.hpp"
#include "compare/commands/flags.hpp"
#include "compare/errors.hpp"
#include "compare/interrupt.hpp"
#include "compare/outputs/file.hpp"
#include "compare/outputs/summary_json.hpp"
#include "compare/paths.hpp"
#include "compare/progress.hpp"
#include "compare/provenance.hpp"
#include "compare/run_folder.hpp"
#include "compare/toml_file.hpp"

namespace compare {
namespace {

constexpr const char* examples =
    R"(The default is Figure 4 of Gil et al. 2010: a square whose edges slide in their plane, wrinkled along every side.

Examples:
  validate bulge
  validate bulge --extent full --cells 60
  validate bulge --shape disc --size "1 um" --edge clamped --E "1.0209 TPa" --thickness "0.335 nm" --nu 0.165 \
      --pretension "0.34 N/m" --pressures "0.1 MPa,1 MPa"
  validate bulge --unrelaxed     # what the sheet does if it could bear compression)";

BulgeResult solve_bulge(const BulgeCase& c, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const membrane::Problem problem = bulge_problem(c);
  BulgeResult result;
  result.resolved = c;
  result.provenance = provenance(command_line());
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    result.pictures.push_back(picture_of(problem, step, c.thickness_A));
    result.points.push_back(bulge_point(problem, step, result.pictures.back()));
    progress.say(fmt::format("membrane  {}/{}  pressure {:.5g} eV/Å³  centre {:.3f} Å  {} Newton steps", step.level + 1,
                             problem.levels.size(), step.pressure_eV_per_A3, step.depth_A, step.newton_iterations));
    return !interrupted();
  });
  result.converged = report.converged;
  result.ended_reason = report.reason;
  result.triangles = report.triangles;
  result.factorisations = report.factorisations;
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

void write_document(const BulgeResult& result, const std::string& target) {
  const std::string text = bulge_document(result).dump(1) + "\n";
  if (target == "-")
    fmt::print("{}", text);
  else
    write_file(target, text);
}

int bulge(const CLI::App& command, const RunOptions& options) {
  check(options);
  BulgeCase c;
  Origins origins = TomlFile(options.case_file.value_or(inputs_folder() / "figure4.toml"), "--case").read(c);
  apply_flags(command, c, origins);
  check(c, origins);
  if (options.dry_run) {
    fmt::print("{}\n", bulge_case_document(c).dump(1));
    return 0;
  }
  atomistic::use_one_math_thread();
  catch_interrupts();
  if (options.json) check_json_target(options.json->string());
  RunFolder folder(options, fmt::format("bulge-{}-{:g}", c.shape, c.size_A), bulge_case_document(c));
  Progress progress(options.quiet);
  const BulgeResult result = solve_bulge(c, progress);
  write_bulge(result, folder.path());
  if (!options.json || *options.json != "-") fmt::print("{}", bulge_table(result));
  if (options.json) write_document(result, options.json->string());
  folder.finish();
  progress.say(fmt::format("wrote {}", folder.path().string()));
  if (interrupted()) throw Error(ExitCode::interrupted, "interrupted; the pressures so far are written");
  return static_cast<int>(result.converged ? ExitCode::success : ExitCode::not_converged);
}

}  // namespace

void add_bulge(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("bulge", "a wrinkling membrane under follower pressure");
  add_flags<BulgeCase>(*command);
  const auto options = std::make_shared<RunOptions>();
  add_run_options(*command, *options);
  command->footer(examples);
  command->callback([command, options, &exit_code] { exit_code = bulge(*command, *options); });
}

}  // namespace compare

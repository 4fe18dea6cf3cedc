// The program `validate`: its commands, and the one place where errors become messages and exit codes.
#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/base/system_failure.hpp"
#include "compare/base/terminal.hpp"
#include "compare/cli/bulge.hpp"
#include "compare/cli/curve.hpp"
#include "compare/cli/design.hpp"
#include "compare/cli/export.hpp"
#include "compare/cli/figure.hpp"
#include "compare/cli/fit.hpp"
#include "compare/cli/flags.hpp"
#include "compare/cli/indentation.hpp"
#include "compare/cli/model.hpp"
#include "compare/cli/potential.hpp"
#include "compare/cli/published.hpp"
#include "compare/cli/report.hpp"
#include "compare/cli/schema.hpp"
#include "compare/cli/verify.hpp"
#include "compare/process/provenance.hpp"

namespace {

using validate::ExitCode;

struct Command {
  std::string_view name;
  void (*add)(CLI::App&, int& exit_code);
};

// Every command of the program.
constexpr std::array commands = {
    Command{"bulge", validate::add_bulge},
    Command{"curve", validate::add_curve},
    Command{"design", validate::add_design},
    Command{"export", validate::add_export},
    Command{"figure", validate::add_figure},
    Command{"fit", validate::add_fit},
    Command{"indentation", validate::add_indentation},
    Command{"model", validate::add_model},
    Command{"potential", validate::add_potential},
    Command{"published", validate::add_published},
    Command{"report", validate::add_report},
    Command{"schema", validate::add_schema},
    Command{"verify", validate::add_verify},
};

int fail(ExitCode code, std::string_view message) {
  validate::print_remark(fmt::format("validate: error: {}\n", message));
  return static_cast<int>(code);
}

// stdout belongs to the results: the log goes to stderr, coloured only on a terminal and without NO_COLOR.
void set_up_log() {
  const char* no_color = std::getenv("NO_COLOR");
  const bool plain = no_color != nullptr && *no_color != '\0';
  auto log = spdlog::stderr_color_mt("validate", plain ? spdlog::color_mode::never : spdlog::color_mode::automatic);
  log->set_error_handler([](const std::string&) {});  // nobody misses what stderr could not take
  log->set_pattern("validate: %^%l%$: %v");
  spdlog::set_default_logger(log);
}

std::vector<std::string_view> command_names() {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

void refuse_unknown_command(std::string_view word) {
  const auto names = command_names();
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw validate::bad_input("unknown command '{}'; allowed: {}{}", word, fmt::join(names, ", "),
                            validate::did_you_mean(word, names));
}

std::string extras_message(const CLI::App& app) {
  const std::string word = app.remaining(true).front();
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) {
    return fmt::format("unknown flag '{}' before the command; use validate COMMAND {} …, commands: {}", word, word,
                       fmt::join(command_names(), ", "));
  }
  const auto parts = chosen.front()->get_subcommands([](const CLI::App*) { return true; });
  if (!word.starts_with('-') && !parts.empty()) {
    std::vector<std::string> owned;
    for (const CLI::App* part : parts) owned.push_back(part->get_name());
    const std::vector<std::string_view> names(owned.begin(), owned.end());
    return fmt::format("unknown {} '{}'; allowed: {}{}", chosen.front()->get_name(), word, fmt::join(owned, ", "),
                       validate::did_you_mean(word, names));
  }
  if (!word.starts_with('-')) return fmt::format("unexpected argument '{}'; a value belongs to a --flag", word);
  const CLI::App& command = *chosen.front();
  const auto names = validate::flag_names(command);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string flag = word.substr(0, word.find('='));
  return fmt::format("unknown flag '{}' (validate {} --help lists all){}", flag, command.get_name(),
                     validate::did_you_mean(flag, candidates));
}

int parse_and_run(CLI::App& app, std::vector<std::string> words, const int& exit_code) {
  try {
    std::ranges::reverse(words);  // as the parser wants them
    app.parse(std::move(words));
    return exit_code;
  } catch (const CLI::ExtrasError&) {
    return fail(ExitCode::bad_input, extras_message(app));
  } catch (const CLI::ParseError& problem) {
    if (problem.get_exit_code() == 0) {  // --help and --version
      std::ostringstream asked_for;
      app.exit(problem, asked_for, asked_for);
      validate::print_text(asked_for.str());
      return 0;
    }
    return fail(ExitCode::bad_input, problem.what());
  }
}

/// Every command, and every part of one, can print its tables whole.
void add_wide(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    command->add_flag_callback("--wide", validate::print_wide,
                               "tables with all their columns, wider than the terminal");
    add_wide(*command);
  }
}

/// `validate help COMMAND` is `validate COMMAND --help`.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words.front() != "help") return words;
  words.erase(words.begin());
  words.emplace_back("--help");  // at the end: of the command named, or of the program
  return words;
}

int run(int argc, char** argv) {
  int exit_code = 0;
  CLI::App app("Does a wrinkling hyperelastic membrane predict what the atoms of graphene do?", "validate");
  app.set_version_flag("--version", [] { return validate::version_text(); });
  app.footer(
      "validate help COMMAND shows the flags of a command.\n"
      "Example: validate indentation --radius 110\n\n"
      "Exit codes: 0 agreement or nothing to judge, 1 internal error, 2 bad input, 3 disagreement, 4 a "
      "solver did\n"
      "not converge, 5 the atomistic program failed, 6 a file could not be read or written, 130 "
      "interrupted.");
  for (const Command& command : commands) command.add(app, exit_code);
  if (argc < 2) {
    validate::print_remark(app.help());
    return static_cast<int>(ExitCode::bad_input);
  }
  add_wide(app);
  const std::vector<std::string> words = words_of(argc, argv);
  refuse_unknown_command(words.front());
  return parse_and_run(app, words, exit_code);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    validate::prepare_streams();
    set_up_log();
    const int exit_code = run(argc, argv);
    validate::check_results_printed();
    return exit_code;
  } catch (const validate::Error& error) {
    return fail(error.exit_code(), error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    const validate::Error known = validate::system_failure(error);
    return fail(known.exit_code(), known.what());
  } catch (const std::system_error& error) {  // no thread, no descriptor
    return fail(ExitCode::file_failed, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::file_failed, "there is not enough memory");
  } catch (const std::exception& error) {
    return fail(ExitCode::internal_error, fmt::format("internal error: {}", error.what()));
  }
}

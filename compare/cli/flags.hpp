// Command-line flags: one for every field of a case, made from describe(), and those of a run.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/input/case.hpp"
#include "compare/input/run_options.hpp"

namespace validate {

/// One case of a batch: the texts that stand for the lists given to --potential and --radius.
struct Variant {
  std::optional<std::string> potential, radius;
};

/// The flags of a case. Lives as long as the command that it was added to.
class CaseFlags {
 public:
  /// The defaults are shown in --help.
  CaseFlags(CLI::App& command, const Case& defaults);

  /// Overwrites the fields whose flags were given and adds "--flag" as their origin.
  /// Throws Error (bad input) that names the flag, the value and what is allowed.
  void apply(Case&, Origins&, const Variant& = {}) const;

  /// The texts of the flags given, as they stand on the command line.
  std::vector<std::string> texts() const;

  /// What --potential and --radius, separated by commas, ask for: every potential with every radius. One empty variant
  /// where neither is a list.
  std::vector<Variant> variants() const;

 private:
  const CLI::App& command_;
};

/// Adds the flags of a run; the options must outlive the parsing.
void add_run_options(CLI::App& command, RunOptions&);

/// Where a command that is no run writes its documents.
struct OutputOptions {
  std::optional<std::filesystem::path> out;
  bool overwrite = false;
};

/// Adds --out, which `meaning` tells of, and --overwrite; the options must outlive the parsing.
void add_output_options(CLI::App& command, OutputOptions&, const std::string& meaning);

/// Refuses options that contradict each other.
void check(const RunOptions&);

/// Names of all flags of a command, with their dashes.
std::vector<std::string> flag_names(const CLI::App& command);

}  // namespace validate

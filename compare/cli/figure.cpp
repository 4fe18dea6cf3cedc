#include "compare/cli/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "atomistic/protocol/math_threads.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/terminal.hpp"
#include "compare/cli/flags.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/process/document_folder.hpp"

namespace validate {
namespace {

struct FigureFlags {
  std::string which;
  OutputOptions output{.out = "figures"};
  std::vector<std::string> potentials;  ///< empty: see potentials_for
  bool quiet = false, atoms = false;
  int starts = 3;
};

std::vector<FigureEntry> chosen(const std::string& which) {
  if (which == "all") return paper_figures();
  for (const FigureEntry& entry : paper_figures())
    if (std::to_string(entry.number) == which) return {entry};
  std::vector<std::string> names;
  for (const FigureEntry& entry : paper_figures()) names.push_back(std::to_string(entry.number));
  throw bad_input("figure: '{}' is none; allowed: {}, all", which, fmt::join(names, ", "));
}

/// The square of figure 4 takes thousands of force computations: a fast potential unless asked otherwise.
std::vector<std::string> potentials_for(int number, const FigureFlags& flags) {
  if (!flags.potentials.empty()) return flags.potentials;
  return number == 4 ? std::vector<std::string>{"tersoff"} : std::vector<std::string>{"airebo", "rebo", "tersoff"};
}

/// Exit code 3 where a number that has to agree does not.
int figure(const FigureFlags& flags) {
  const std::vector<FigureEntry> entries = chosen(flags.which);
  atomistic::use_one_math_thread();
  catch_interrupts();
  OutputFolder folder(*flags.output.out, flags.output.overwrite);
  Progress progress(flags.quiet);
  bool all_pass = true;
  for (const FigureEntry& entry : entries) {
    const PaperFigure made =
        entry.make({folder.work(), potentials_for(entry.number, flags), flags.atoms, flags.starts, progress});
    write_paper_figure(made, folder.drafts());
    folder.publish();
    print_text(numbers_text(made) + "\n");
    all_pass = all_pass && std::ranges::all_of(made.numbers, passes);
  }
  const auto code = static_cast<int>(all_pass ? ExitCode::success : ExitCode::disagreement);
  folder.finish(code);
  return code;
}

}  // namespace

void add_figure(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("figure", "the paper's figures from scratch: SVG, PNG, CSV, HDF5");
  const auto flags = std::make_shared<FigureFlags>();
  std::string list = "which: all";
  std::string footer = "Figures:\n";
  for (const FigureEntry& entry : paper_figures()) {
    list += fmt::format(", {}", entry.number);
    footer += fmt::format("  {}  {}\n", entry.number, entry.what);
  }
  command->add_option("which", flags->which, list)->required()->type_name("N");
  add_output_options(*command, flags->output, "folder; default figures");
  command->add_option("--potential", flags->potentials, "for the atoms; default airebo,rebo,tersoff; figure 4: tersoff")
      ->delimiter(',')
      ->type_name("NAME,...");
  command->add_flag("--atoms", flags->atoms, "figure 4: the same square as atoms beside the membrane (minutes)");
  command
      ->add_option("--starts", flags->starts, "figure 4 with atoms: searches for the lowest state; 1 to 20, default 3")
      ->check(CLI::Range(1, 20))
      ->type_name("N");
  command->add_flag("--quiet", flags->quiet, "no progress on stderr");
  command->footer(
      footer +
      "\nExamples:\n  validate figure 1 --out figures\n  validate figure 4 --atoms --potential rebo --starts 4");
  command->callback([flags, &exit_code] { exit_code = figure(*flags); });
}

}  // namespace validate

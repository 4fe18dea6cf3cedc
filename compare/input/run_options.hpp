// What a run is told that is not part of the case: it changes where and how, never the numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace validate {

struct RunOptions {
  std::optional<std::filesystem::path> case_file;  ///< absent: the command's own file in inputs/
  std::optional<std::filesystem::path> out;        ///< absent: runs/<command>-<potential>-R<radius>
  std::optional<std::filesystem::path> json;       ///< summary.json once more; "-" is stdout
  int ranks = 0;                                   ///< MPI ranks; 0: chosen by the program
  std::string launcher;                            ///< command before validate-atoms; empty: mpiexec where needed
  bool all_fields = false;                         ///< fields of the membranes at every depth
  bool allow_code = false;                         ///< a potential may bring a program
  bool quiet = false, resume = false, overwrite = false, dry_run = false;
};

}  // namespace validate

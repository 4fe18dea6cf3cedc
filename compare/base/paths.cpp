#include "compare/base/paths.hpp"

#include <cstdlib>
#include <system_error>

#include "compare/base/errors.hpp"

namespace validate {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

fs::path program_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

fs::path find_inputs(const fs::path& program_folder, std::string_view from_environment) {
  const auto holds_inputs = [](const fs::path& folder) { return is_there(folder / "potentials" / ""); };
  if (!from_environment.empty()) {
    const fs::path folder(from_environment);
    if (holds_inputs(folder)) return fs::absolute(folder);
    throw bad_input("VALIDATE_INPUTS: '{}' is not a folder of inputs (it must hold potentials/)", folder.string());
  }
  const fs::path in_build_tree = (program_folder / "../inputs").lexically_normal();
  const fs::path installed = (program_folder / "../share/validate").lexically_normal();
  if (holds_inputs(in_build_tree)) return in_build_tree;
  if (holds_inputs(installed)) return installed;
  throw bad_input("the inputs (case files and potentials) are neither in '{}' nor in '{}'; set VALIDATE_INPUTS",
                  in_build_tree.string(), installed.string());
}

fs::path inputs_folder() {
  const char* from_environment = std::getenv("VALIDATE_INPUTS");
  return find_inputs(program_folder(), from_environment ? from_environment : "");
}

fs::path atoms_program() {
  const fs::path program = program_folder() / "validate-atoms";
  if (is_there(program)) return program;
  throw Error(ExitCode::atomistic_failed,
              fmt::format("the atomistic program '{}' is missing; it belongs beside validate", program.string()));
}

}  // namespace validate

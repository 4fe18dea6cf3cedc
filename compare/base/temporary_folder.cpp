#include "compare/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include "compare/base/errors.hpp"

namespace validate {

TemporaryFolder::TemporaryFolder(const std::string& prefix) {
  std::string name = (std::filesystem::temp_directory_path() / (prefix + "-XXXXXX")).string();
  if (!::mkdtemp(name.data())) throw Error(ExitCode::file_failed, fmt::format("cannot make the folder '{}'", name));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!kept_) std::filesystem::remove_all(path_, ignored);
}

}  // namespace validate

#include "compare/base/system_failure.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <system_error>

namespace validate {

Error system_failure(std::string_view what, int error) {
  return Error(error == ENAMETOOLONG ? ExitCode::bad_input : ExitCode::file_failed,
               fmt::format("{}: {}", what, std::generic_category().message(error)));
}

Error system_failure(const std::filesystem::filesystem_error& error) {
  return system_failure(fmt::format("cannot use '{}'", error.path1().string()), error.code().value());
}

}  // namespace validate

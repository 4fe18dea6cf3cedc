#include "compare/base/read_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "compare/base/errors.hpp"

namespace validate {

std::string read_file(const std::filesystem::path& file, std::string_view label) {
  const std::string start = label.empty() ? std::string{} : fmt::format("{}: ", label);
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw bad_input("{}there is no file '{}'", start, file.string());
  }
  if (status.type() == std::filesystem::file_type::directory) {
    throw bad_input("{}'{}' is a folder, not a file", start, file.string());
  }
  try {
    std::ifstream in;
    in.exceptions(std::ios::failbit | std::ios::badbit);
    errno = 0;
    in.open(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  } catch (const std::ios_base::failure&) {  // says less than errno
    const std::string reason = std::generic_category().message(errno);
    throw Error(ExitCode::file_failed, fmt::format("{}cannot read '{}': {}", start, file.string(), reason));
  }
}

}  // namespace validate

#include "compare/input/case_file.hpp"

#include "compare/base/toml_file.hpp"
#include "compare/input/potential_file.hpp"

namespace validate {

Origins read_case(const std::filesystem::path& file, Case& c, std::string_view label) {
  Origins origins = TomlFile(file, label).read(c);
  if (origins.contains("potential") && is_path(c.potential)) {
    c.potential = (std::filesystem::absolute(file).parent_path() / c.potential).lexically_normal().string();
  }
  return origins;
}

}  // namespace validate

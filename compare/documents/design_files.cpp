#include "compare/documents/design_files.hpp"

#include <spdlog/spdlog.h>

#include "compare/base/file.hpp"
#include "compare/documents/plots/design_plot.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/texts/json.hpp"

namespace validate {

void write_design_files(const Result& result, const std::filesystem::path& folder) {
  write_file(folder / "design.json", json_text(result));
  if (const auto warning = write_plot(design_plot(*result.design), folder, "design")) spdlog::warn("{}", *warning);
}

}  // namespace validate

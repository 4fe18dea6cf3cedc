#include "compare/documents/outputs.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <exception>

#include "compare/documents/bytes/vtu.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/force_depth.hpp"
#include "compare/documents/plots/window_scan.hpp"
#include "compare/documents/run_h5.hpp"
#include "compare/documents/texts/curves_csv.hpp"
#include "compare/documents/texts/summary_json.hpp"

namespace validate {

namespace {

using Write = void (*)(const Result&, const std::filesystem::path& folder);

void figure(const Result& result, const std::filesystem::path& folder) {
  if (const auto warning = write_plot(force_depth_plot(result), folder, "figure")) spdlog::warn("{}", *warning);
}

void scan(const Result& result, const std::filesystem::path& folder) {
  if (const auto warning = write_plot(window_scan_plot(result), folder, "window_scan")) spdlog::warn("{}", *warning);
}

/// membrane-<load>-<constants>.pvd and its VTU files, for every membrane whose sheet was kept.
void sheets(const Result& result, const std::filesystem::path& folder) {
  for (const Run& run : result.runs)
    if (run.pictures && !run.pictures->empty())
      write_pvd(*run.pictures, folder, fmt::format("membrane-{}-{}", run.load, to_string(run.constants)));
}

// Numbers first, pictures last.
constexpr Write documents[] = {write_run_h5, write_curves, write_summary, sheets, figure, scan};

}  // namespace

void write_all(const Result& result, const std::filesystem::path& folder) {
  std::exception_ptr first_failure;
  for (const Write write : documents) {
    try {
      write(result, folder);
    } catch (const std::exception&) {
      if (!first_failure) first_failure = std::current_exception();
    }
  }
  if (first_failure) std::rethrow_exception(first_failure);
}

}  // namespace validate

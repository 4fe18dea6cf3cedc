#include "compare/documents/texts/batch_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "compare/documents/texts/summary_json.hpp"

namespace validate {
namespace {

using Json = nlohmann::ordered_json;

std::string number_cell(const Json& value, double factor, const char* format) {
  return value.is_number() ? fmt::format(fmt::runtime(format), factor * value.get<double>()) : "-";
}

Json member(const Json& object, const char* name) { return object.is_object() ? object.value(name, Json()) : Json(); }

std::string curve_row(const BatchEntry& entry, const Json& run) {
  const Json agreement = member(entry.summary, "agreement"), fit = member(run, "fit");
  const bool judged = agreement.is_object() && member(agreement, "load") == member(run, "load");
  return fmt::format("{:<14}{:>7g}{:>9} {:<7}{:>15}{:>11}{:>12}{:>15}{:>11}  {}\n",
                     std::filesystem::path(entry.potential).stem().string(), entry.radius_A,
                     number_cell(member(member(entry.summary, "card"), "Eh_N_per_m"), 1, "{:.1f}"),
                     run["load"].get<std::string>(),
                     number_cell(member(fit, "Eh_N_per_m"), 1, "{:.1f}") + " ± " +
                         number_cell(member(fit, "Eh_stderr_N_per_m"), 1, "{:.1f}"),
                     number_cell(member(member(fit, "bias"), "Eh_corrected_N_per_m"), 1, "{:.1f}"),
                     number_cell(member(member(fit, "direct"), "Eh_N_per_m"), 1, "{:.1f}"),
                     number_cell(member(fit, "pretension_N_per_m"), 1, "{:.3f}") + " ± " +
                         number_cell(member(fit, "pretension_stderr_N_per_m"), 1, "{:.3f}"),
                     judged ? number_cell(agreement["max_relative_difference"], 100, "{:.2f}") : "",
                     judged ? (agreement["passed"].get<bool>() ? "agreement" : "disagreement") : "");
}

}  // namespace

Json batch_document(const std::vector<BatchEntry>& entries) {
  Json document{{"schema", summary_schema}, {"cases", Json::array()}};
  for (const BatchEntry& entry : entries)
    document["cases"].push_back({{"potential", entry.potential},
                                 {"radius_A", entry.radius_A},
                                 {"folder", entry.folder},
                                 {"exit_code", entry.exit_code},
                                 {"summary", entry.summary}});
  return document;
}

std::string batch_table(const std::vector<BatchEntry>& entries) {
  std::string text = fmt::format("{:<14}{:>7}{:>9} {:<7}{:>15}{:>11}{:>12}{:>15}{:>11}  {}\n", "potential", "R", "card",
                                 "load", "Eq. 16 E·h", "corrected", "membrane", "pretension", "largest", "verdict");
  text += fmt::format("{:<14}{:>7}{:>9} {:<7}{:>15}{:>11}{:>12}{:>15}{:>11}\n", "", "Å", "N/m", "", "N/m ± error",
                      "N/m", "itself N/m", "N/m ± error", "diff. %");
  for (const BatchEntry& entry : entries) {
    if (!entry.summary.is_object())
      text += fmt::format("{:<14}{:>7g}  failed, exit code {}: see {}.log\n", entry.potential, entry.radius_A,
                          entry.exit_code, entry.folder);
    for (const Json& run : member(entry.summary, "runs"))
      if (member(run, "model") == "atomistic") text += curve_row(entry, run);
  }
  return text;
}

}  // namespace validate

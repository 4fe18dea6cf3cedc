#include "compare/documents/curve_files.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <set>

#include "compare/base/file.hpp"
#include "compare/documents/bytes/recording_h5.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/recording_plot.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/recording_text.hpp"

namespace validate {
namespace {

/// Of the file's name, with the curve's index where the file has several; a number where that is taken.
std::string name_of(const Recording& recording, bool several, std::set<std::string>& taken) {
  std::string stem = std::filesystem::path(recording.file).stem().string();
  std::ranges::replace(stem, ' ', '_');
  std::ranges::replace(stem, ':', '_');
  if (several) stem += fmt::format("-{}", recording.index);
  std::string name = "curve-" + stem;
  for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("curve-{}-{}", stem, i);
  return name;
}

}  // namespace

void write_curve_files(const Result& result, const std::filesystem::path& folder, const CurveDocuments& which) {
  if (which.json) write_file(folder / "curve.json", json_text(result));
  if (which.h5) write_recordings_h5(result.recordings, folder / "curves.h5");
  std::set<std::string> taken;
  for (const Recording& recording : result.recordings) {
    const bool several = std::ranges::count(result.recordings, recording.file, &Recording::file) > 1;
    const std::string name = name_of(recording, several, taken);
    if (which.csv) write_file(folder / (name + ".csv"), recording_csv(recording));
    if (!which.picture) continue;
    if (const auto warning = draw(recording_plot(recording), folder, name)) spdlog::warn("{}", *warning);
  }
}

}  // namespace validate

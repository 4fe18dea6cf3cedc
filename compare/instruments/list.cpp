#include <algorithm>
#include <array>
#include <fstream>

#include "compare/base/errors.hpp"
#include "compare/base/read_file.hpp"
#include "compare/instruments/afm_workshop.hpp"
#include "compare/instruments/afmformats_tab.hpp"
#include "compare/instruments/chiaro.hpp"
#include "compare/instruments/columns_h5.hpp"
#include "compare/instruments/delimited.hpp"
#include "compare/instruments/format.hpp"
#include "compare/instruments/igor.hpp"
#include "compare/instruments/jpk.hpp"
#include "compare/instruments/jpk_text.hpp"
#include "compare/instruments/map.hpp"
#include "compare/instruments/nanoscope.hpp"
#include "compare/instruments/nanoscope_text.hpp"
#include "compare/instruments/nanosurf.hpp"
#include "compare/instruments/ntmdt_text.hpp"
#include "compare/instruments/own_curves.hpp"

namespace validate {
namespace {

// What recognises less comes later.
const std::array formats = {jpk_format,      igor_format,           columns_h5_format,     nanoscope_format,
                            nanosurf_format, afmformats_tab_format, own_curves_format,     afm_workshop_format,
                            chiaro_format,   jpk_text_format,       nanoscope_text_format, ntmdt_text_format,
                            delimited_format};

std::string names() {
  std::string text;
  for (const InstrumentFormat& format : formats) text += (text.empty() ? "" : ", ") + std::string(format.name);
  return text;
}

std::unique_ptr<Recordings> open_content(const FileContent& file, const Calibration& calibration) {
  for (const InstrumentFormat& format : formats)
    if (format.recognises(file)) return format.open(file, calibration);
  throw bad_input("{}: no format that is read here; it is told by the content, allowed are: {}", file.name, names());
}

/// Every curve of every member, in order of the members' names.
std::unique_ptr<Recordings> open_members(const FileContent& file, const Calibration& calibration) {
  std::vector<std::string> members = file.archive->names();
  std::ranges::sort(members);
  std::vector<Recording> recordings;
  for (const std::string& member : members) {
    const std::string content = file.archive->read(member);
    const auto part = open_content({.name = file.name + ": " + member, .bytes = content}, calibration);
    for (std::size_t i = 0; i < part->size(); ++i) recordings.push_back(part->read(i));
  }
  if (recordings.empty()) throw bad_input("{}: the archive is empty", file.name);
  number_as_map(recordings);
  return std::make_unique<ReadyRecordings>(std::move(recordings));
}

}  // namespace

std::span<const InstrumentFormat> instrument_formats() { return formats; }

std::unique_ptr<Recordings> open_recordings(const std::filesystem::path& file, const Calibration& calibration) {
  std::string first(4, '\0');
  std::ifstream(file, std::ios::binary).read(first.data(), static_cast<std::streamsize>(first.size()));
  FileContent content{.name = file.string(), .path = file};
  if (looks_like_zip(first) && std::filesystem::is_regular_file(file)) {
    content.archive = open_zip(file);
    if (jpk_format.recognises(content)) return jpk_format.open(content, calibration);
    return open_members(content, calibration);
  }
  const std::string bytes = read_file(file);
  if (bytes.empty()) throw bad_input("{}: the file is empty", file.string());
  content.bytes = bytes;
  return open_content(content, calibration);
}

}  // namespace validate

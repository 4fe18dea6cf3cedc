#include "compare/instruments/nanoscope_text.hpp"

#include "compare/base/errors.hpp"
#include "compare/instruments/assemble.hpp"
#include "compare/instruments/delimited.hpp"
#include "compare/instruments/nanoscope_header.hpp"
#include "compare/instruments/table.hpp"
#include "compare/instruments/text.hpp"

namespace validate {
namespace {

/// With the file's header, whose lines are quoted, or with the columns alone: Calc_Ramp_Ex_nm, Defl_V_Rt, …
bool recognises_text(const FileContent& file) {
  if (file.archive || !is_text(file.bytes)) return false;
  const std::string head = to_utf8(file.bytes.substr(0, 200000));
  const auto column = head.find("_Ex");
  return (head.starts_with("\"\\*") || (column != std::string::npos && head.find("_Rt") != std::string::npos)) &&
         has_table(head);
}

/// A key of the header; remarks have it in lower case behind its backslash, in CIAO's form behind "@4:" too.
std::string header_text(const Recording& recording, std::string_view key) {
  for (const auto& [name, text] : recording.remarks)
    if (name.ends_with(key) && (name.starts_with('\\') || name.starts_with("@"))) return text;
  return {};
}

std::unique_ptr<Recordings> open_text(const FileContent& file, const Calibration& calibration) {
  Recording recording = read_delimited(file, nanoscope_text_format.name);
  RecordingMetadata& m = recording.metadata;
  m.software = "NanoScope";
  m.imaging_mode = "force-distance";
  const std::string k = header_text(recording, "spring constant");
  if (!k.empty()) m.spring_constant_N_per_m = number_of(cells_of(k, ' ').front()).value_or(not_known);
  const NanoscopeValue sensitivity = nanoscope_value(header_text(recording, "sens. deflsens"));
  const auto unit = si_unit(sensitivity.unit);
  if (sensitivity.soft && unit && unit->unit == "m/V") m.sensitivity_m_per_V = *sensitivity.soft * unit->factor;
  calibrate(recording, calibration);
  return std::make_unique<ReadyRecordings>(std::vector{std::move(recording)});
}

}  // namespace

const InstrumentFormat nanoscope_text_format = {"NanoScope text", ".txt", recognises_text, open_text};

}  // namespace validate

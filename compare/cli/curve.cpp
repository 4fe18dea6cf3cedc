#include "compare/cli/curve.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/nearest.hpp"
#include "compare/cli/flags.hpp"
#include "compare/documents/curve_files.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/recording_text.hpp"
#include "compare/instruments/format.hpp"
#include "compare/instruments/si_quantity.hpp"
#include "compare/instruments/text.hpp"
#include "compare/process/document_folder.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

struct CurveFlags {
  std::vector<std::string> files;
  std::string spring_constant, sensitivity, as = "json,csv,h5,picture";
  OutputOptions output;
  std::string json;
};

CurveDocuments documents_of(const std::string& list) {
  CurveDocuments which{false, false, false, false};
  static constexpr std::string_view names[] = {"json", "csv", "h5", "picture"};
  for (const std::string_view name : cells_of(list, ',')) {
    if (name == "json")
      which.json = true;
    else if (name == "csv")
      which.csv = true;
    else if (name == "h5")
      which.h5 = true;
    else if (name == "picture")
      which.picture = true;
    else
      throw bad_input("--as: '{}'; allowed, separated by commas: json, csv, h5, picture{}", printable(name),
                      did_you_mean(name, names));
  }
  return which;
}

int curve(const CurveFlags& flags) {
  const Calibration calibration{si_quantity(flags.spring_constant, {"N/m"}, "--spring-constant", "0.05 N/m"),
                                si_quantity(flags.sensitivity, {"m/V", "m/A"}, "--sensitivity", "60 nm/V")};
  const CurveDocuments which = documents_of(flags.as);
  Result result;
  result.command = Command::curve;
  result.provenance = provenance(command_line());
  for (const std::string& file : flags.files) {
    const auto recordings = open_recordings(file, calibration);
    for (std::size_t i = 0; i < recordings->size(); ++i) result.recordings.push_back(recordings->read(i));
  }
  if (flags.json != "-")
    for (const Recording& recording : result.recordings) fmt::print("{}\n", recording_text(recording));
  if (!flags.json.empty()) write_json(result, flags.json);
  if (flags.output.out) {
    OutputFolder folder(*flags.output.out, flags.output.overwrite);
    write_curve_files(result, folder.drafts(), which);
    folder.finish(0);
  }
  return 0;
}

std::string footer() {
  std::string text = "Formats, told by the content:\n";
  for (const InstrumentFormat& format : instrument_formats())
    text += fmt::format("  {:<24} {}\n", format.name, format.example);
  return text +
         "\nUnits are SI, signs and zeros those of the file; heights fall towards the sample.\n\n"
         "Examples:\n"
         "  validate curve map.jpk-force-map\n"
         "  validate curve curve.txt --spring-constant \"0.05 N/m\" --sensitivity \"60 nm/V\" --out curves\n"
         "  validate curve *.ibw --json -";
}

}  // namespace

void add_curve(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("curve", "what is in an instrument's file; as CSV, HDF5, picture");
  const auto flags = std::make_shared<CurveFlags>();
  command->add_option("files", flags->files, "files of force curves, also zipped")->required()->type_name("FILE");
  const auto text = [&](const char* name, std::string& value, const char* meaning, const char* type = "VALUE") {
    command->add_option(name, value, meaning)->type_name(type);
  };
  text("--spring-constant", flags->spring_constant, "of the cantilever, where the file has none; N/m");
  text("--sensitivity", flags->sensitivity,
       "of the deflection, where the file has none; m/V, or m/A where the detector's signal is a current");
  text("--as", flags->as, "what is written to --out, separated by commas; default json,csv,h5,picture", "NAMES");
  add_output_options(*command, flags->output, "folder for CSV, HDF5, pictures and curve.json; default: none");
  text("--json", flags->json, "write the columns there; - is stdout", "FILE");
  command->footer(footer());
  command->callback([flags, &exit_code] { exit_code = curve(*flags); });
}

}  // namespace validate

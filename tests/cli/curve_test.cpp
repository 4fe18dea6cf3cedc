// `validate curve`, and `validate fit` of what instruments write.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_support.hpp"

namespace {

using cli_tests::expect_says;
using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::WorkFolder;
using nlohmann::json;

const std::string samples = INSTRUMENT_DATA;
const std::string relaxation = samples + "/fmt-jpk-sr_cell1-0008.jpk-force";

TEST(CurveCommand, ItsDocumentHasTheLayoutOfItsSchema) {
  const WorkFolder folder;
  const Outcome outcome = run_validate({"curve", relaxation, "--json", "-"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  cli_tests::expect_valid(document, "curve");
  const json& curve = document["curves"][0];
  EXPECT_EQ(curve["index"], 0);
  EXPECT_EQ(curve["segments"][3]["points"], 1951);
  EXPECT_NEAR(curve["metadata"]["spring_constant_N_per_m"].get<double>(), 1.0677, 1e-12);
  for (const char* name : {"force", "height (measured)", "height (piezo)", "deflection", "time"}) {
    EXPECT_EQ(curve["columns"][name]["values"].size(), 11935u) << name;
    EXPECT_FALSE(curve["columns"][name]["unit"].get<std::string>().empty()) << name;
  }
}

TEST(CurveCommand, AMapBecomesDocumentsOfEachCurve) {
  const WorkFolder folder;
  const std::string map = samples + "/fmt-afm-workshop-fd_mapping_16_2018-08-01_13.07.zip";
  const Outcome outcome = run_validate(
      {"curve", map, "--spring-constant", "20 N/m", "--sensitivity", "10 nm/V", "--out", "out", "--as", "csv,h5,json"},
      folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("grid_shape_x             4"), std::string::npos) << outcome.out;
  int tables = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out"))
    tables += entry.path().extension() == ".csv" ? 1 : 0;
  EXPECT_EQ(tables, 16);
  const Outcome again = run_validate({"curve", "out/curves.h5", "--json", "-"}, folder.path());
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["curves"].size(), 16u);
}

TEST(FitCommand, TakesTheRunsThatAreAskedFor) {
  const WorkFolder folder;
  const Outcome made =
      run_validate({"indentation", "--models", "membrane", "--loads", "point,disc", "--radius", "60", "--E", "5",
                    "--thickness", "1", "--nu", "0.2", "--tip-radius", "6", "--out", "run"},
                   folder.path());
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto fit = [&](const std::string& runs) {
    return run_validate({"fit", "run/curves.csv", "--run", runs, "--radius", "60 A", "--nu", "0.2", "--tip", "disc",
                         "--tip-radius", "6 A", "--json", "-"},
                        folder.path());
  };
  const Outcome one = fit("1");
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const json document = json::parse(one.out);
  ASSERT_EQ(document["curves"].size(), 1u);
  for (const json& reading : document["curves"][0]["fits"]) {
    if (reading["model"] != "membrane") continue;
    EXPECT_NEAR(reading["Eh_eV_per_A2"].get<double>(), 5, 0.01);
  }
  for (const char* no_list : {"x", "0,,1", "-1", "1.5"})
    expect_says(fit(no_list), 2, {"--run", "no list of curves", "0,2,5"});
  expect_says(fit("7"), 2, {"--run", "no curve 7", "it has 0, 1"});
}

TEST(FitCommand, ABadFileAmongSeveralDoesNotStopTheOthers) {
  const WorkFolder folder;
  folder.write("noise.csv", "depth_nm,force_nN\n1,x\n");
  const std::string good = std::string(SOURCE_INPUTS) + "/measured/synthetic-034.csv";
  const Outcome outcome = run_validate({"fit", "noise.csv", good, "--json", "-"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  cli_tests::expect_valid(document, "fit");
  EXPECT_EQ(document["curves"].size(), 1u);
  ASSERT_EQ(document["unfitted"].size(), 1u);
  EXPECT_EQ(document["unfitted"][0]["file"], "noise.csv");
  EXPECT_NE(outcome.err.find("noise.csv"), std::string::npos) << outcome.err;
  EXPECT_EQ(run_validate({"fit", "noise.csv", "noise.csv"}, folder.path()).exit_code, 2);
}

TEST(CurveCommand, BadInputIsNamed) {
  const WorkFolder folder;
  folder.write("noise.bin", std::string("\x01\x02\x1b[31m\0\xff", 9));
  const auto expect = [&](const cli_tests::Words& words, const cli_tests::Words& said) {
    const Outcome outcome = run_validate(words, folder.path());
    expect_says(outcome, 2, said);
    EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos);
    EXPECT_EQ(outcome.out, "");
  };
  expect({"curve", "noise.bin"}, {"noise.bin", "JPK", "Igor"});
  expect({"fit", "noise.bin", "--radius", "0.5 um", "--nu", "0.165"}, {"noise.bin", "JPK"});
  expect({"curve", relaxation, "--spring-constant", "3 kg"}, {"--spring-constant", "N/m"});
  expect({"curve", relaxation, "--as", "cvs"}, {"--as", "'csv'?"});
  expect({"fit", relaxation, "--radius", "0.5 um", "--nu", "0.165", "--segment", "way"}, {"--segment", "approach"});
}

/// A shipped curve as an instrument has it: heights that fall, a deflection in V with an offset, both ways.
std::string raw_text(double stiffness_N_per_m, double sensitivity_m_per_V) {
  std::ifstream in(std::string(SOURCE_INPUTS) + "/measured/synthetic-034.csv");
  std::vector<std::pair<double, double>> points;  // m, N
  for (std::string line; std::getline(in, line);)
    if (line.find_first_of("0123456789") < 2)
      points.emplace_back(1e-9 * std::stod(line), 1e-9 * std::stod(line.substr(line.find(',') + 1)));
  std::vector<std::pair<double, double>> way;
  for (int i = 0; i < 100; ++i) way.emplace_back(1e-9 * (i - 120), points[static_cast<std::size_t>(i % 20)].second);
  way.insert(way.end(), points.begin(), points.end());
  std::ostringstream out;
  out.precision(12);
  for (const char* kind : {"extend", "retract"}) {
    out << "# segment: " << kind << "\n# columns: height vDeflection\n# units: m V\n";
    for (const auto& [depth, force] : way)
      out << 3e-5 - depth - force / stiffness_N_per_m << ' ' << force / stiffness_N_per_m / sensitivity_m_per_V + 0.3
          << '\n';
    std::ranges::reverse(way);
  }
  return out.str();
}

TEST(FitCommand, FindsTheTruthInWhatAnInstrumentWrites) {
  const WorkFolder folder;
  folder.write("raw.txt", raw_text(2, 60e-9));
  // A tilt that has to be found from 100 nm before the contact costs more than half of what is known.
  for (const auto& [baseline, error] : {std::pair{"tilt", 20.0}, std::pair{"level", 10.0}}) {
    const Outcome outcome = run_validate(
        {"fit", "raw.txt", "--radius", "0.5 um", "--nu", "0.165", "--tip", "disc", "--tip-radius", "16.5 nm",
         "--spring-constant", "2 N/m", "--sensitivity", "60 nm/V", "--baseline", baseline, "--json", "-"},
        folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json curve = json::parse(outcome.out)["curves"][0], fits = curve["fits"];
    ASSERT_EQ(fits.size(), 2u);
    EXPECT_NEAR(fits[1]["Eh_N_per_m"].get<double>(), 342, 4 * fits[1]["Eh_stderr_N_per_m"].get<double>());
    EXPECT_LT(fits[1]["Eh_stderr_N_per_m"].get<double>(), error) << baseline;
    EXPECT_EQ(curve["preparation"]["baseline"], baseline);
  }
  expect_says(run_validate({"fit", "raw.txt", "--radius", "0.5 um", "--nu", "0.165"}, folder.path()), 2,
              {"raw.txt", "deflection in V", "--sensitivity"});
}

}  // namespace

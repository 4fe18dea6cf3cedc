#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "compare/base/errors.hpp"
#include "compare/documents/texts/json.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/json_schema.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;
using nlohmann::json;

namespace {

const support::JsonSchema& schema() {
  static const support::JsonSchema parsed(support::read_json(SUMMARY_SCHEMA));
  return parsed;
}

// Through text, as a reader gets it.
json parsed(const Result& result) { return json::parse(json_text(result)); }

std::string problems(const json& doc) {
  std::string text;
  for (const std::string& line : schema().problems(doc)) text += line + "\n";
  return text;
}

TEST(SummaryJson, EveryKindOfResultIsValid) {
  EXPECT_EQ(problems(parsed(sample::full())), "");
  EXPECT_EQ(problems(parsed(sample::membrane_only())), "");
  EXPECT_EQ(problems(parsed(sample::atoms_failed())), "");
}

TEST(SummaryJson, HoldsTheNumbers) {
  const Result result = sample::full();
  const json doc = parsed(result);
  EXPECT_EQ(doc["schema"], 2);
  EXPECT_EQ(doc["command"], "indentation");
  EXPECT_EQ(doc["exit_code"], 0);
  EXPECT_EQ(doc["case"]["radius_A"], 110);
  EXPECT_EQ(doc["case"]["agreement"]["tolerance"], 0.01);
  EXPECT_EQ(doc["sheet"]["atoms"], 17244);
  EXPECT_EQ(doc["card"]["Eh_eV_per_A2"], 17.33);
  EXPECT_NEAR(doc["card"]["Eh_N_per_m"], 277.657, 1e-3);  // 17.33 × 16.02176634
  EXPECT_EQ(doc["timing"]["force_calls"], 260);
  EXPECT_EQ(doc["provenance"]["gsl"], "2.7.1");
  ASSERT_EQ(doc["runs"].size(), 10u);

  const json& atoms = doc["runs"][1];
  EXPECT_EQ(atoms["model"], "atomistic");
  EXPECT_TRUE(atoms["constants"].is_null());
  EXPECT_FALSE(atoms.contains("triangles"));
  EXPECT_EQ(atoms["force_eV_per_A"][3], result.runs[1].force_eV_per_A[3]);  // digits survive
  EXPECT_EQ(atoms["fits"][0]["points"], result.runs[1].fits.at(0).points);
  EXPECT_FALSE(atoms.contains("fit_skipped"));

  const json& membrane = doc["runs"][4];
  EXPECT_EQ(membrane["constants"], "paper");
  EXPECT_EQ(membrane["triangles"], 1936);
  EXPECT_FALSE(membrane.contains("artefact"));
  EXPECT_EQ(doc["agreement"]["against"], "sheet");
  EXPECT_EQ(doc["law"]["coefficient_eV_per_A2"].size(), 4u);
  EXPECT_EQ(doc["explanation"].size(), 2u);
  EXPECT_EQ(doc["agreement"]["outcome"], to_string(result.agreement->outcome));
  EXPECT_EQ(doc["agreement"]["ratios"].size(), result.agreement->ratios.size());
  EXPECT_EQ(doc["agreement"]["ratios"][0]["ratio"], result.agreement->ratios.at(0).ratio);
}

TEST(SummaryJson, ArraysOfARunAreEquallyLong) {
  const json doc = parsed(sample::full());
  for (const json& run : doc["runs"]) {
    const std::size_t points = run["depth_A"].size();
    EXPECT_GT(points, 4u);
    for (const auto& [name, value] : run.items()) {
      if (!value.is_array() || name == "fits") continue;
      EXPECT_EQ(value.size(), points) << run["model"] << ' ' << name;
    }
  }
}

TEST(SummaryJson, WhatFailedIsNull) {
  const json doc = parsed(sample::atoms_failed());
  for (const char* key : {"sheet", "card", "agreement"}) EXPECT_TRUE(doc[key].is_null()) << key;
  EXPECT_TRUE(doc["timing"]["atomistic_s"].is_null());
  EXPECT_TRUE(doc["timing"]["membrane_s"].is_null());
  EXPECT_TRUE(doc["provenance"]["lammps"].is_null());
  EXPECT_FALSE(doc["agreement_skipped"].get<std::string>().empty());
  const json& atoms = doc["runs"][0];
  EXPECT_TRUE(atoms["fits"].empty());
  for (const char* key : {"ended", "Eh_eV_per_A2", "Eh_N_per_m", "nu"}) EXPECT_TRUE(atoms[key].is_null()) << key;
  EXPECT_FALSE(atoms["fit_skipped"].get<std::string>().empty());

  Result infinite = sample::full();
  infinite.runs[0].force_eV_per_A[2] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(parsed(infinite)["runs"][0]["force_eV_per_A"][2].is_null());
  EXPECT_EQ(problems(parsed(infinite)), "");
}

// Each takes a valid document and spoils one thing.
struct Corruption {
  const char* name;
  void (*apply)(json&);
};

class SummarySchema : public testing::TestWithParam<Corruption> {};

TEST_P(SummarySchema, RejectsACorruptedDocument) {
  json doc = parsed(sample::full());
  ASSERT_EQ(problems(doc), "");
  GetParam().apply(doc);
  EXPECT_NE(problems(doc), "") << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(
    Corruptions, SummarySchema,
    testing::Values(
        Corruption{"wrong_schema_number", [](json& d) { d["schema"] = 1; }},
        Corruption{"no_runs", [](json& d) { d.erase("runs"); }},
        Corruption{"unknown_key", [](json& d) { d["extra"] = 1; }},
        Corruption{"unknown_key_in_case", [](json& d) { d["case"]["extra"] = 1; }},
        Corruption{"negative_radius", [](json& d) { d["case"]["radius_A"] = -1; }},
        Corruption{"no_atoms", [](json& d) { d["sheet"]["atoms"] = 0; }},
        Corruption{"card_without_twin", [](json& d) { d["card"].erase("Eh_N_per_m"); }},
        Corruption{"text_for_number", [](json& d) { d["card"]["nu"] = "0.36"; }},
        Corruption{"unknown_model", [](json& d) { d["runs"][0]["model"] = "plate"; }},
        Corruption{"unknown_load", [](json& d) { d["runs"][0]["load"] = "needle"; }},
        Corruption{"unknown_end", [](json& d) { d["runs"][0]["ended"] = "tired"; }},
        Corruption{"constants_of_atoms", [](json& d) { d["runs"][0]["constants"] = "card"; }},
        Corruption{"membrane_without_constants", [](json& d) { d["runs"][2].erase("constants"); }},
        Corruption{"membrane_of_no_constants", [](json& d) { d["runs"][2]["constants"] = nullptr; }},
        Corruption{"atoms_without_artefacts", [](json& d) { d["runs"][0].erase("artefact"); }},
        Corruption{"membrane_with_artefacts", [](json& d) { d["runs"][2]["artefact"] = json::array(); }},
        Corruption{"sheet_without_iterations", [](json& d) { d["runs"][9].erase("newton_iterations"); }},
        Corruption{"law_without_coefficients", [](json& d) { d["law"].erase("coefficient_eV_per_A2"); }},
        Corruption{"explanation_without_bending", [](json& d) { d["explanation"][0].erase("bending"); }},
        Corruption{"number_for_flag", [](json& d) { d["runs"][0]["converged"][0] = 1; }},
        Corruption{"fraction_of_an_evaluation", [](json& d) { d["runs"][0]["force_evaluations"][0] = 1.5; }},
        Corruption{"no_fit_without_reason", [](json& d) { d["runs"][0]["fits"] = json::array(); }},
        Corruption{"fit_and_reason", [](json& d) { d["runs"][0]["fit_skipped"] = "why"; }},
        Corruption{"fit_of_three_points", [](json& d) { d["runs"][0]["fits"][0]["points"] = 3; }},
        Corruption{"fit_without_error", [](json& d) { d["runs"][0]["fits"][0].erase("Eh_stderr_N_per_m"); }},
        Corruption{"window_of_one", [](json& d) { d["agreement"]["window"] = {0.1}; }},
        Corruption{"no_agreement_without_reason", [](json& d) { d["agreement"] = nullptr; }},
        Corruption{"null_verdict", [](json& d) { d["agreement"]["outcome"] = nullptr; }},
        Corruption{"unknown_verdict", [](json& d) { d["agreement"]["outcome"] = "perhaps"; }},
        Corruption{"ratio_without_depth", [](json& d) { d["agreement"]["ratios"][0].erase("depth_A"); }},
        Corruption{"no_wall_time", [](json& d) { d["timing"].erase("wall_s"); }},
        Corruption{"broken_hash", [](json& d) { d["provenance"]["potential_sha256"] = "abc"; }}),
    [](const auto& test) { return test.param.name; });

TEST(SummaryJson, AFileAndStdoutHoldTheSameDocument) {
  const TemporaryFolder folder;
  const Result result = sample::full();
  write_json(result, (folder / "summary.json").string());
  testing::internal::CaptureStdout();
  write_json(result, "-");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), folder.read("summary.json"));
  EXPECT_EQ(json::parse(folder.read("summary.json")), parsed(result));
  EXPECT_THROW(write_json(result, (folder / "no/folder.json").string()), Error);
}

TEST(SummaryJson, AForeignByteInAPathDoesNotLoseTheDocument) {
  const TemporaryFolder folder;
  Result result = sample::full();
  result.provenance.command_line = "validate indentation --out caf\xe9";
  write_json(result, (folder / "summary.json").string());
  EXPECT_EQ(problems(json::parse(folder.read("summary.json"))), "");
}

}  // namespace

// The schemas: those in inputs/ are the generated ones, and every document is one of theirs.
#include "compare/documents/texts/schema.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/base/read_file.hpp"
#include "compare/documents/texts/json.hpp"
#include "tests/compare/results/complete_result.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/json_schema.hpp"

using namespace validate;
using nlohmann::json;

namespace {

class Schema : public testing::TestWithParam<NamedSchema> {};

TEST_P(Schema, InInputsIsTheGeneratedOne) {
  const std::string name(GetParam().name), file = std::string(VALIDATE_SOURCE_INPUTS) + "/" + name + ".schema.json";
  EXPECT_TRUE(read_file(file) == schema_text(GetParam().command))
      << "make it anew: validate schema " << name << " > inputs/" << name << ".schema.json";
}

std::string problems(const Result& result) {
  const support::JsonSchema schema(json::parse(schema_of(result.command).dump()));
  std::string text;
  for (const std::string& line : schema.problems(json::parse(json_text(result)))) text += line + "\n";
  return text;
}

TEST_P(Schema, HoldsADocumentWithEverythingInIt) { EXPECT_EQ(problems(sample::complete(GetParam().command)), ""); }

TEST_P(Schema, RefusesAForeignMemberAndAMissingOne) {
  const support::JsonSchema schema(json::parse(schema_of(GetParam().command).dump()));
  const json whole = json::parse(json_text(sample::complete(GetParam().command)));
  json more = whole;
  more["extra"] = 1;
  EXPECT_FALSE(schema.problems(more).empty());
  for (const char* name : {"schema", "command", "exit_code", "provenance"}) {
    json less = whole;
    less.erase(name);
    EXPECT_FALSE(schema.problems(less).empty()) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Named, Schema, testing::ValuesIn(named_schemas),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Schemas, ABulgesDocumentIsAnExperiments) {
  EXPECT_EQ(problems(sample::complete(Command::bulge)), "");
  const support::JsonSchema summary(json::parse(schema_of(Command::indentation).dump()));
  EXPECT_TRUE(summary.problems(json::parse(json_text(sample::complete(Command::bulge)))).empty());
}

TEST(Schemas, WhatOccursMoreThanOnceIsCheckedWhereverItDoes) {
  const json whole = json::parse(json_text(sample::complete(Command::indentation)));
  const json schema = json::parse(schema_of(Command::indentation).dump());
  ASSERT_TRUE(schema["definitions"].contains("fits"));
  for (std::size_t run = 0; run < whole["runs"].size(); ++run) {
    json wrong = whole;
    ASSERT_FALSE(wrong["runs"][run]["fits"].empty()) << run;
    wrong["runs"][run]["fits"][0]["extra"] = 1;
    EXPECT_FALSE(support::JsonSchema(schema).problems(wrong).empty()) << run;
  }
}

TEST(Schemas, EveryCommandHasOne) {
  for (const std::string_view name : all_words<Command>) {
    const Command command = *from_word<Command>(name);
    const bool named = std::ranges::any_of(named_schemas, [&](const NamedSchema& s) { return s.command == command; });
    EXPECT_TRUE(named || command == Command::bulge) << name;
  }
}

}  // namespace

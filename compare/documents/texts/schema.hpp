// The JSON schema of each document, made from the same describe() as the document itself.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "compare/results/result.hpp"

namespace validate {

/// Draft 7, for the documents of one command. Objects that occur more than once stand among its definitions.
nlohmann::ordered_json schema_of(Command command);

/// The file in inputs/: a property of a plain value on one line.
std::string schema_text(Command command);

/// A schema by the name of its file in inputs/ (NAME.schema.json): summary, fit, card, figure, verify, batch,
/// published, curve, design.
struct NamedSchema {
  std::string_view name;
  Command command;
};
inline constexpr NamedSchema named_schemas[] = {
    {"summary", Command::indentation}, {"fit", Command::fit},       {"card", Command::potential},
    {"figure", Command::figure},       {"verify", Command::verify}, {"batch", Command::batch},
    {"published", Command::published}, {"curve", Command::curve},   {"design", Command::design}};

}  // namespace validate

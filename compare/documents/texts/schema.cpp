#include "compare/documents/texts/schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/base/keys.hpp"
#include "compare/base/walk.hpp"
#include "compare/documents/texts/schema_form.hpp"

namespace validate {
namespace {

using Json = nlohmann::ordered_json;
using Pictures = std::shared_ptr<const std::vector<SheetPicture>>;

/// One of each form that a struct can take.
template <class Struct>
std::vector<Struct> prototypes(const Struct&) {
  return {Struct{}};
}

template <Described Struct>
Json schema_for(const Field& field, const Struct& s);

Json within_range(const Field& field, Json schema) {
  const auto [low, high, low_open, high_open] = field.range;
  if (std::isfinite(low)) schema[low_open ? "exclusiveMinimum" : "minimum"] = low;
  if (std::isfinite(high)) schema[high_open ? "exclusiveMaximum" : "maximum"] = high;
  return schema;
}

Json schema_for(const Field& field, double) { return within_range(field, {{"type", {"number", "null"}}}); }
Json schema_for(const Field&, bool) { return {{"type", "boolean"}}; }
Json schema_for(const Field& field, int) { return within_range(field, {{"type", "integer"}}); }
Json schema_for(const Field& field, long) { return within_range(field, {{"type", "integer"}}); }
Json schema_for(const Field& field, const std::string&) {
  if (!field.choices.empty()) return {{"enum", field.choices}};
  return {{"type", {"string", "null"}}};
}
Json schema_for(const Field&, const Pair&) {
  return {{"type", "array"}, {"items", {{"type", {"number", "null"}}}}, {"minItems", 2}, {"maxItems", 2}};
}
Json schema_for(const Field&, const std::shared_ptr<const Result>&) {
  return {{"type", {"object", "null"}}, {"$comment", "as summary.schema.json"}};
}
template <Worded Enum>
Json schema_for(const Field&, Enum) {
  return {{"enum", all_words<Enum>}};
}

Json or_null(Json schema) {
  if (schema.contains("enum")) {
    schema["enum"].push_back(nullptr);
  } else if (schema.contains("type") && schema["type"] != "object" && schema["type"] != "array") {
    Json& type = schema["type"];
    if (type.is_string()) type = {type, "null"};
  } else {
    return {{"oneOf", {{{"type", "null"}}, schema}}};
  }
  return schema;
}

template <class T>
Json schema_for(const Field& field, const std::optional<T>&) {
  return or_null(schema_for(field, T{}));
}
template <class T>
Json schema_for(const Field& field, const std::vector<T>&) {
  return {{"type", "array"}, {"items", schema_for(field, T{})}};
}

std::string described(const Field& field) {
  return fmt::format("{}{}", field.meaning, field.unit.empty() ? "" : fmt::format(" ({})", field.unit));
}

/// Adds each member to the properties of an object's schema, members of a table to those of an object inside it.
class AddProperties {
 public:
  explicit AddProperties(Json& schema) : schema_(schema) {}

  void operator()(const Field&, const Pictures&) const {}

  template <Variant Part>
  void operator()(const Field&, const Part& part) const {
    std::visit([this](const auto& members) { describe_with_twins(members, *this); }, part);
  }

  template <class T>
  void operator()(const Field& field, const T& value) const {
    Json& object = field.table.empty() ? schema_ : table(std::string(field.table));
    Json property = schema_for(field, value);
    if (!field.meaning.empty()) property["description"] = described(field);
    object["properties"][key(field)] = std::move(property);
    if (!field.may_lack) object["required"].push_back(key(field));
  }

 private:
  Json& table(const std::string& name) const {
    Json& properties = schema_["properties"];
    if (!properties.contains(name)) {
      properties[name] = {{"type", "object"},
                          {"properties", Json::object()},
                          {"required", Json::array()},
                          {"additionalProperties", false}};
      schema_["required"].push_back(name);
    }
    return properties[name];
  }

  Json& schema_;
};

/// What one member owes to another, beyond the members themselves.
template <class Struct>
void add_relations(const Struct&, Json&) {}

/// One of the two is there: what was found (an object, or a list with something in it), or the reason why not.
Json either_or_why(const char* found, Json there, Json missing, const char* why) {
  return Json::array({{{"properties", {{found, std::move(there)}}}, {"not", {{"required", {why}}}}},
                      {{"properties", {{found, std::move(missing)}}}, {"required", {why}}}});
}

void add_relations(const Run& run, Json& schema) {
  Json& properties = schema["properties"];
  if (run.is_atomistic()) {
    properties["model"] = {{"const", to_string(Model::atomistic)}, {"description", properties["model"]["description"]}};
    properties["constants"] = {{"type", "null"}};
  } else {
    properties["model"]["enum"] = {to_string(Model::membrane), to_string(Model::sheet)};
    properties["constants"]["enum"] = all_words<Constants>;
  }
  schema["anyOf"] = either_or_why("fits", {{"minItems", 1}}, {{"maxItems", 0}}, "fit_skipped");
}

void must_be_sha256(Json& property) { property["pattern"] = "^[0-9a-f]{64}$"; }
void add_relations(const Provenance&, Json& schema) { must_be_sha256(schema["properties"]["potential_sha256"]); }
void add_relations(const PotentialSummary&, Json& schema) { must_be_sha256(schema["properties"]["sha256"]); }

void add_relations(const Result& result, Json& schema) {
  if (result.is_experiment())
    schema["anyOf"] = either_or_why("agreement", {{"type", "object"}}, {{"type", "null"}}, "agreement_skipped");
}

template <Described Struct>
Json object_schema(const Struct& prototype) {
  Json schema{
      {"type", "object"}, {"properties", Json::object()}, {"required", Json::array()}, {"additionalProperties", false}};
  describe_with_twins(prototype, AddProperties(schema));
  add_relations(prototype, schema);
  return schema;
}

template <Described Struct>
Json schema_for(const Field&, const Struct& s) {
  Json forms = Json::array();
  for (const Struct& prototype : prototypes(s)) forms.push_back(object_schema(prototype));
  return forms.size() == 1 ? forms[0] : Json{{"anyOf", forms}};
}

/// Commands whose documents are of the same form.
std::vector<std::string_view> names_of(Command command) {
  if (command == Command::indentation || command == Command::bulge)
    return {to_string(Command::indentation), to_string(Command::bulge)};
  return {to_string(command)};
}

}  // namespace

Json schema_of(Command command) {
  Result prototype;
  prototype.command = command;
  if (command == Command::potential) prototype.card.emplace();
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", fmt::format("documents of validate {}, schema {}", fmt::join(names_of(command), " and "),
                                    document_schema)},
              {"description",
               "A name ends in its unit. Forces are totals on the full sheet. What failed or is not known is "
               "null, never 0."}};
  schema.update(object_schema(prototype));
  schema["properties"]["schema"] = {{"const", document_schema}};
  schema["properties"]["command"]["enum"] = names_of(command);
  share_repeated_objects(schema);
  return schema;
}

}  // namespace validate

#include "compare/documents/texts/schema_form.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "compare/documents/texts/schema.hpp"

namespace validate {
namespace {

using Json = nlohmann::ordered_json;

bool describes_object(const Json& schema) {
  return schema.is_object() && schema.contains("properties") && schema.value("type", Json()) == "object";
}

std::string without_description(Json schema) {
  schema.erase("description");
  return schema.dump();
}

class Repeated {
 public:
  explicit Repeated(const Json& schema) { count(schema); }

  /// Replaces what is repeated within a schema; `name` is the property that it belongs to.
  void replace(Json& schema, const std::string& name) {
    const std::string content = describes_object(schema) ? without_description(schema) : std::string();
    for (auto& [key, inner] : schema.items()) {
      if (!inner.is_structured()) continue;
      if (key == "properties")
        for (auto& [property, its] : inner.items()) replace(its, property);
      else
        replace(inner, name);
    }
    const auto found = times_.find(content);
    if (found == times_.end() || found->second < 2) return;
    auto [known, added] = names_.emplace(content, name);
    if (added) {
      while (definitions.contains(known->second)) known->second += "_";
      Json& definition = definitions[known->second] = schema;
      definition.erase("description");
    }
    Json reference{{"$ref", "#/definitions/" + known->second}};
    if (schema.contains("description")) reference["description"] = schema["description"];
    schema = std::move(reference);
  }

  Json definitions = Json::object();

 private:
  void count(const Json& schema) {
    if (describes_object(schema)) ++times_[without_description(schema)];
    for (const Json& inner : schema)
      if (inner.is_structured()) count(inner);
  }

  std::map<std::string, int> times_;
  std::map<std::string, std::string> names_;
};

bool holds_object(const Json& schema) {
  if (describes_object(schema)) return true;
  return schema.is_structured() && std::ranges::any_of(schema, holds_object);
}

void print(const Json& schema, bool broken, std::size_t depth, std::string& text) {
  if (!schema.is_structured()) {
    text += schema.dump();
    return;
  }
  text += schema.is_object() ? '{' : '[';
  const std::string next_line = "\n" + std::string(depth + 1, ' ');
  bool first = true;
  for (const auto& [key, inner] : schema.items()) {
    text += first ? "" : broken ? "," : ", ";
    if (broken) text += next_line;
    if (schema.is_object()) text += Json(key).dump() + ": ";
    print(inner, holds_object(inner) || (key == "properties" && describes_object(schema)), depth + 1, text);
    first = false;
  }
  if (broken) text += "\n" + std::string(depth, ' ');
  text += schema.is_object() ? '}' : ']';
}

}  // namespace

void share_repeated_objects(Json& schema) {
  Repeated repeated(schema);
  for (auto& [name, property] : schema["properties"].items()) repeated.replace(property, name);
  if (!repeated.definitions.empty()) schema["definitions"] = repeated.definitions;
}

std::string schema_text(Command command) {
  std::string text;
  print(schema_of(command), true, 0, text);
  return text + "\n";
}

}  // namespace validate

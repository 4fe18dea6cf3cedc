#include "compare/base/toml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/read_file.hpp"

// toml++ 3.3 aborts on some malformed bytes through TOML_ASSERT, and with NDEBUG it tells the compiler that
// they cannot occur. Both are wrong for a user's file: as set here the parser goes on to report the error.
// The built library has its asserts compiled in, so it is used header-only, whatever its CMake target says.
#undef NDEBUG
#undef TOML_HEADER_ONLY
#undef TOML_SHARED_LIB
#define TOML_ASSERT(condition)
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

namespace validate {

struct TomlFile::Content {
  std::shared_ptr<const toml::table> whole;
  const toml::table& root;  ///< the whole, or a table in it
};

namespace {

std::string place(const std::filesystem::path& file, const toml::source_position& at) {
  return fmt::format("{}:{}", file.string(), at.line);
}

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

[[noreturn]] void refuse_type(const toml::node& node, std::string_view label, std::string_view expected) {
  throw bad_input("{}: expected {}, found {}", label, expected, type_name(node));
}

double number_from(const Field& field, std::string_view label, const toml::node& node) {
  if (const auto* text = node.as_string(); text && !field.unit.empty()) {
    return parse_number(field, text->get(), label);
  }
  // value_exact would refuse an integer such as 110
  if (!node.is_number()) {
    refuse_type(node, label,
                field.unit.empty() ? "a number" : fmt::format("a number in {} or a text with a unit", field.unit));
  }
  const double value = *node.value<double>();
  if (field.needs_unit) refuse_without_unit(field, fmt::format("{}", value), label);
  return in_range(field, value, label);
}

std::string text_from(const Field& field, std::string_view label, const toml::node& node) {
  const auto* text = node.as_string();
  if (!text) refuse_type(node, label, "a text in quotes");
  return parse_text(field, text->get(), label);
}

const toml::array& list_from(const toml::node& node, std::string_view label) {
  const auto* list = node.as_array();
  if (!list) refuse_type(node, label, "a list in [ ]");
  if (list->empty()) throw bad_input("{}: the list is empty; at least one value is needed", label);
  return *list;
}

const toml::node* find_node(const toml::table& root, const Field& field) {
  if (field.table.empty()) return root.get(field.name);
  const toml::node* table = root.get(field.table);
  const toml::node* found = table && table->is_table() ? table->as_table()->get(field.name) : nullptr;
  return !found && field.top_too ? root.get(field.name) : found;
}

std::shared_ptr<const toml::table> parse(const std::filesystem::path& file, std::string_view label) {
  try {
    return std::make_shared<const toml::table>(toml::parse(read_file(file, label), file.string()));
  } catch (const toml::parse_error& problem) {
    throw bad_input("{}:{}: not valid TOML: {}", place(file, problem.source().begin), problem.source().begin.column,
                    problem.description());
  }
}

std::vector<std::string_view> keys_of(const std::vector<Field>& fields, std::string_view table) {
  std::vector<std::string_view> keys;
  for (const Field& field : fields) {
    if (field.table == table || (table.empty() && field.top_too)) keys.push_back(field.name);
  }
  return keys;
}

std::vector<std::string_view> tables_of(const std::vector<Field>& fields) {
  std::vector<std::string_view> tables;
  for (const Field& field : fields) {
    const bool seen = std::find(tables.begin(), tables.end(), field.table) != tables.end();
    if (!field.table.empty() && !seen) tables.push_back(field.table);
  }
  return tables;
}

std::string place_of_table(std::string_view table) {
  return table.empty() ? "the top level" : fmt::format("[{}]", table);
}

[[noreturn]] void refuse_key(const std::string& where, std::string_view key, std::string_view table,
                             const std::vector<Field>& fields) {
  for (const Field& field : fields) {
    if (field.name == key) {
      throw bad_input("{}: the key '{}' belongs to {}, not to {}", where, key, place_of_table(field.table),
                      place_of_table(table));
    }
  }
  const auto allowed = keys_of(fields, table);
  throw bad_input("{}: unknown key '{}' in {}; allowed: {}{}", where, key, place_of_table(table),
                  fmt::join(allowed, ", "), did_you_mean(key, allowed));
}

}  // namespace

TomlFile::TomlFile(std::filesystem::path file, std::string_view label) : file_(std::move(file)) {
  const auto whole = parse(file_, label);
  content_ = std::make_unique<const Content>(Content{whole, *whole});
}

TomlFile::TomlFile(std::filesystem::path file, std::unique_ptr<const Content> content)
    : file_(std::move(file)), content_(std::move(content)) {}

TomlFile::TomlFile(TomlFile&&) noexcept = default;
TomlFile::~TomlFile() = default;

std::vector<TomlFile> TomlFile::tables(std::string_view name) const {
  for (const auto& [key, node] : content_->root)
    if (key.str() != name)
      throw bad_input("{}: '{}' stands outside of [[{}]]; allowed at the top level: [[{}]]{}",
                      place(file_, key.source().begin), key.str(), name, name, did_you_mean(key.str(), {&name, 1}));
  const toml::node* list = content_->root.get(name);
  if (!list) throw bad_input("{}: there is no [[{}]] in it", file_.string(), name);
  const toml::array* array = list->as_array();
  if (!array)
    refuse_type(*list, fmt::format("{}: {}", place(file_, list->source().begin), name),
                fmt::format("a list of tables, [[{}]]", name));
  std::vector<TomlFile> found;
  for (const toml::node& node : *array) {
    if (!node.is_table())
      refuse_type(node, fmt::format("{}: {}", place(file_, node.source().begin), name),
                  fmt::format("a table, [[{}]]", name));
    found.push_back(TomlFile(file_, std::make_unique<const Content>(Content{content_->whole, *node.as_table()})));
  }
  return found;
}

std::string TomlFile::where() const { return place(file_, content_->root.source().begin); }

void TomlFile::refuse_unknown_keys(const std::vector<Field>& fields) const {
  const auto tables = tables_of(fields);
  const auto refuse_unknown = [&](const toml::table& table, std::string_view name) {
    const auto known = keys_of(fields, name);
    for (const auto& [key, node] : table) {
      const bool is_table_name = name.empty() && std::find(tables.begin(), tables.end(), key.str()) != tables.end();
      const bool is_key = std::find(known.begin(), known.end(), key.str()) != known.end();
      if (!is_key && !is_table_name) refuse_key(place(file_, key.source().begin), key.str(), name, fields);
    }
  };
  for (const auto& [key, node] : content_->root) {
    const bool is_key_of_table = std::find(tables.begin(), tables.end(), key.str()) != tables.end();
    if (node.is_table() && !is_key_of_table) {
      throw bad_input("{}: unknown table [{}]; allowed: {}{}", place(file_, key.source().begin), key.str(),
                      tables.empty() ? "none" : fmt::format("[{}]", fmt::join(tables, "], [")),
                      did_you_mean(key.str(), tables));
    }
    if (!node.is_table() && is_key_of_table) {
      refuse_type(node, fmt::format("{}: {}", place(file_, key.source().begin), key.str()),
                  fmt::format("a table, [{}]", key.str()));
    }
    if (node.is_table()) refuse_unknown(*node.as_table(), key.str());
  }
  refuse_unknown(content_->root, "");
}

std::optional<std::string> TomlFile::find(const Field& field) const {
  const toml::node* node = find_node(content_->root, field);
  if (!node) return std::nullopt;
  return fmt::format("{}: {}", place(file_, node->source().begin), field.name);
}

void TomlFile::read_value(const Field& field, const std::string& label, double& value) const {
  value = number_from(field, label, *find_node(content_->root, field));
}

void TomlFile::read_value(const Field& field, const std::string& label, std::optional<double>& value) const {
  value = number_from(field, label, *find_node(content_->root, field));
}

void TomlFile::read_value(const Field& field, const std::string& label, bool& value) const {
  const toml::node& node = *find_node(content_->root, field);
  if (!node.is_boolean()) refuse_type(node, label, "true or false");
  value = node.as_boolean()->get();
}

void TomlFile::read_value(const Field& field, const std::string& label, std::string& value) const {
  value = text_from(field, label, *find_node(content_->root, field));
}

void TomlFile::read_value(const Field& field, const std::string& label, std::vector<double>& value) const {
  value.clear();
  for (const toml::node& node : list_from(*find_node(content_->root, field), label)) {
    value.push_back(number_from(field, label, node));
  }
}

std::vector<std::string> TomlFile::texts(const Field& field, const std::string& label) const {
  std::vector<std::string> found;
  for (const toml::node& node : list_from(*find_node(content_->root, field), label))
    found.push_back(text_from(field, label, node));
  return found;
}

void TomlFile::read_value(const Field& field, const std::string& label, std::vector<std::string>& value) const {
  value = texts(field, label);
}

}  // namespace validate

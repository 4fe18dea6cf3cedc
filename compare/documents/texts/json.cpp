#include "compare/documents/texts/json.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/keys.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/base/walk.hpp"

namespace validate {
namespace {

using Json = nlohmann::ordered_json;
using Pictures = std::shared_ptr<const std::vector<SheetPicture>>;

template <Described Struct>
Json json_of(const Struct& s);

Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
template <class T>
requires std::is_integral_v<T> Json json_of(T value) { return value; }
Json json_of(const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); }
template <Worded Enum>
Json json_of(Enum value) {
  return to_string(value);
}
Json json_of(const Pair& value) { return {json_of(value[0]), json_of(value[1])}; }
Json json_of(const std::shared_ptr<const Result>& value) { return value ? document(*value) : Json(nullptr); }
template <class T>
Json json_of(const std::optional<T>& value) {
  return value ? json_of(*value) : Json(nullptr);
}
template <class T>
Json json_of(const std::vector<T>& values) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(json_of(value));
  return array;
}

/// Adds each described member to an object, members of a table to an object inside it.
class AddTo {
 public:
  explicit AddTo(Json& object) : object_(object) {}

  void operator()(const Field&, const Pictures&) const {}  // too large for a text: in run.h5

  template <Variant Part>
  void operator()(const Field&, const Part& part) const {
    std::visit([this](const auto& members) { describe_with_twins(members, *this); }, part);
  }

  template <class T>
  void operator()(const Field& field, const T& value) const {
    if (field.may_lack && lacks(value)) return;
    Json& place = field.table.empty() ? object_ : object_[std::string(field.table)];
    place[key(field)] = json_of(value);
  }

 private:
  Json& object_;
};

template <Described Struct>
Json json_of(const Struct& s) {
  Json object = Json::object();
  describe_with_twins(s, AddTo(object));
  return object;
}

}  // namespace

Json document(const Result& result) { return json_of(result); }
Json document(const Case& resolved) { return json_of(resolved); }

std::string json_text(const Result& result) {
  return document(result).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void check_json_target(const std::string& target) {
  if (target == "-") return;
  std::error_code error;
  if (std::filesystem::is_directory(target, error))
    throw Error(ExitCode::file_failed, fmt::format("--json: cannot write '{}': it is a folder", target));
  check_users_file(target);
}

void write_json(const Result& result, const std::string& target) {
  const std::string text = json_text(result);
  if (target == "-")
    print_result(text);
  else
    write_users_file(target, text);
}

}  // namespace validate

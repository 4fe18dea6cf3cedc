#include "compare/documents/texts/summary_json.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/results/keys.hpp"

namespace validate {

namespace {

using Json = nlohmann::ordered_json;

Json to_json_value(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json to_json_value(int value) { return value; }
Json to_json_value(long value) { return value; }
Json to_json_value(bool value) { return value; }
Json to_json_value(const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); }
Json to_json_value(Model value) { return to_string(value); }
Json to_json_value(Constants value) { return to_string(value); }
Json to_json_value(Ended value) { return to_string(value); }
Json to_json_value(Regime value) { return to_string(value); }

template <class T>
Json to_json_value(const std::optional<T>& value) {
  return value ? to_json_value(*value) : Json(nullptr);
}

template <class List>
requires requires(const List& list) {
  typename List::value_type;
  list.size();
} &&(!std::is_same_v<List, std::string>)Json to_json_value(const List& list) {
  Json array = Json::array();
  for (const typename List::value_type& value : list) array.push_back(to_json_value(value));
  return array;
}

// Adds each described member to an object, members of a table to an object inside it.
class AddTo {
 public:
  explicit AddTo(Json& object) : object_(object) {}

  template <class T>
  void operator()(const Field& field, const T& value) const {
    Json& place = field.table.empty() ? object_ : object_[std::string(field.table)];
    place[key(field)] = to_json_value(value);
  }

 private:
  Json& object_;
};

template <class Struct>
Json object_of(const Struct& described) {
  Json object = Json::object();
  describe_with_twins(described, AddTo(object));
  return object;
}

template <class Struct>
Json object_of(const std::optional<Struct>& described) {
  return described ? object_of(*described) : Json(nullptr);
}

template <class Struct>
Json columns_of(const Struct& described) {
  Json object = Json::object();
  describe_points(described, AddTo(object));
  return object;
}

Json run_object(const Run& run) {
  Json object = object_of(run);
  describe_points(run, AddTo(object));
  object["fit"] = run.fit ? fit_document(*run.fit) : Json(nullptr);
  if (!run.fit) object["fit_skipped"] = to_json_value(run.fit_skipped);
  if (run.contact) object["contact"] = object_of(*run.contact);
  if (!run.scan.depth_max_A.empty()) object["window_scan"] = columns_of(run.scan);
  return object;
}

Json agreement_object(const Agreement& agreement) {
  Json object = object_of(agreement);
  describe_points(agreement, AddTo(object));
  return object;
}

}  // namespace

nlohmann::ordered_json fit_document(const Fit& fit) {
  Json object = object_of(fit);
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) object[name] = to_json_value(value);
  };
  add("depth_offset_A", fit.depth_offset_A);
  add("depth_offset_stderr_A", fit.depth_offset_stderr_A);
  add("force_offset_eV_per_A", fit.force_offset_eV_per_A);
  add("force_offset_stderr_eV_per_A", fit.force_offset_stderr_eV_per_A);
  describe_points(fit, AddTo(object));
  object["bias"] = object_of(fit.bias);
  object["direct"] = object_of(fit.direct);
  return object;
}

nlohmann::ordered_json case_document(const Case& resolved) { return object_of(resolved); }

nlohmann::ordered_json summary_document(const Result& result) {
  Json document;
  document["schema"] = summary_schema;
  document["case"] = case_document(result.resolved);
  document["sheet"] = object_of(result.sheet);
  document["card"] = object_of(result.card);
  if (result.law) {
    document["law"] = object_of(*result.law);
    describe_points(*result.law, AddTo(document["law"]));
  } else {
    document["law"] = nullptr;
  }
  document["runs"] = Json::array();
  for (const Run& run : result.runs) document["runs"].push_back(run_object(run));
  document["agreement"] = result.agreement ? agreement_object(*result.agreement) : Json(nullptr);
  if (!result.agreement) document["agreement_skipped"] = to_json_value(result.agreement_skipped);
  document["comparison"] = Json::array();
  for (const Comparison& comparison : result.comparisons) {
    document["comparison"].push_back(object_of(comparison));
    describe_points(comparison, AddTo(document["comparison"].back()));
  }
  document["explanation"] = Json::array();
  for (const Explanation& explanation : result.explanations) {
    document["explanation"].push_back(object_of(explanation));
    describe_points(explanation, AddTo(document["explanation"].back()));
  }
  if (!result.unloading.empty()) {
    document["unloading"] = Json::array();
    for (const Unloading& back : result.unloading) document["unloading"].push_back(object_of(back));
  }
  document["timing"] = object_of(result.timing);
  document["provenance"] = object_of(result.provenance);
  return document;
}

namespace {

// A path or a command line need not be UTF-8; its foreign bytes become replacement characters.
std::string as_text(const Result& result) {
  return summary_document(result).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void write_summary(const Result& result, const std::filesystem::path& folder) {
  write_file(folder / "summary.json", as_text(result));
}

void check_json_target(const std::string& target) {
  if (target == "-") return;
  if (std::filesystem::is_directory(target))
    throw Error(ExitCode::file_failed, fmt::format("--json: cannot write '{}': it is a folder", target));
  const PendingFile removed_again(target);
}

void write_json(const Result& result, const std::string& target) {
  const std::string text = as_text(result);
  if (target != "-") return write_file(target, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw Error(ExitCode::file_failed, "cannot write the JSON document to stdout");
  }
}

}  // namespace validate

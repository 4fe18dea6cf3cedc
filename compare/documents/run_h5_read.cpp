#include "compare/documents/run_h5_read.hpp"

#include <fmt/core.h>

#include <type_traits>

#include "compare/base/errors.hpp"
#include "compare/documents/bytes/h5_read.hpp"
#include "compare/documents/texts/summary_json.hpp"
#include "compare/results/keys.hpp"

namespace validate {
namespace {

template <class Enum>
Enum enum_from(const std::string& text, std::initializer_list<Enum> values) {
  for (const Enum value : values)
    if (to_string(value) == text) return value;
  throw bad_input("run.h5 holds the unknown word '{}'", text);
}

void from_text(const std::string& text, Model& value) {
  value = enum_from(text, {Model::membrane, Model::atomistic, Model::sheet});
}
void from_text(const std::string& text, Constants& value) {
  value =
      enum_from(text, {Constants::card, Constants::paper, Constants::given, Constants::calibrated, Constants::none});
}
void from_text(const std::string& text, Ended& value) {
  value = enum_from(text, {Ended::depth_max, Ended::artefact, Ended::rupture, Ended::not_converged});
}
void from_text(const std::string& text, Regime& value) {
  value = enum_from(text, {Regime::bending, Regime::membrane, Regime::softening, Regime::artefact});
}

/// Reads each described member from the attribute of its name, where there is one.
class AttributesInto {
 public:
  explicit AttributesInto(const h5::ReadGroup& group) : group_(group) {}

  template <class T>
  void operator()(const Field& field, T& value) const {
    if (field.table.empty()) return read(group_, key(field), value);
    if (const auto table = group_.group(field.table)) read(*table, key(field), value);
  }

 private:
  template <class T>
  static void read(const h5::ReadGroup& group, const std::string& name, std::optional<T>& value) {
    if (!group.has_attribute(name)) return;
    value.emplace();
    read(group, name, *value);
  }
  template <class T>
  static void read(const h5::ReadGroup& group, const std::string& name, T& value) {
    if (!group.has_attribute(name)) return;
    if constexpr (std::is_enum_v<T>) {
      from_text(group.text(name), value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      value = group.text(name);
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
      value = group.texts(name);
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
      value = group.numbers(name);
    } else if constexpr (std::is_same_v<T, std::array<double, 2>>) {
      const std::vector<double> both = group.numbers(name);
      if (both.size() == 2) value = {both[0], both[1]};
    } else {
      value = static_cast<T>(group.number(name));
    }
  }

  const h5::ReadGroup& group_;
};

template <class Struct>
void read_columns(const h5::ReadGroup& group, Struct& described) {
  describe_points(described, [&group](const Field& field, auto& values) {
    using Value = typename std::remove_reference_t<decltype(values)>::value_type;
    if constexpr (std::is_enum_v<Value>) {
      for (const std::string& text : group.text_column(key(field))) from_text(text, values.emplace_back());
    } else {
      for (const double value : group.column(key(field))) values.push_back(static_cast<Value>(value));
    }
  });
}

template <class Struct>
void read_optional(const h5::ReadGroup& parent, std::string_view name, std::optional<Struct>& into) {
  const auto group = parent.group(name);
  if (group) describe(into.emplace(), AttributesInto(*group));
}

Fit read_fit(const h5::ReadGroup& group) {
  Fit fit;
  describe(fit, AttributesInto(group));
  read_columns(group, fit);
  read_optional(group, "bias", fit.bias);
  read_optional(group, "direct", fit.direct);
  return fit;
}

Run read_run(const h5::ReadGroup& group) {
  Run run;
  if (group.has_attribute("constants")) run.constants = Constants::given;  // so that describe() visits it
  if (group.has_attribute("model")) from_text(group.text("model"), run.model);
  describe(run, AttributesInto(group));
  read_columns(group, run);
  read_optional(group, "contact", run.contact);
  if (const auto fit = group.group("fit")) run.fit = read_fit(*fit);
  if (group.has_attribute("fit_skipped")) run.fit_skipped = group.text("fit_skipped");
  if (const auto scan = group.group("window_scan")) read_columns(*scan, run.scan);
  return run;
}

Result read_result(const h5::ReadGroup& root) {
  Result result;
  if (const auto group = root.group("case")) describe(result.resolved, AttributesInto(*group));
  read_optional(root, "sheet", result.sheet);
  read_optional(root, "card", result.card);
  if (const auto runs = root.group("runs"))
    for (int i = 0; const auto run = runs->group(std::to_string(i)); ++i) result.runs.push_back(read_run(*run));
  read_optional(root, "agreement", result.agreement);
  if (result.agreement) read_columns(*root.group("agreement"), *result.agreement);
  if (root.has_attribute("agreement_skipped")) result.agreement_skipped = root.text("agreement_skipped");
  if (const auto law = root.group("law")) {
    describe(result.law.emplace(), AttributesInto(*law));
    read_columns(*law, *result.law);
  }
  if (const auto all = root.group("explanation"))
    for (int i = 0; const auto one = all->group(std::to_string(i)); ++i) {
      describe(result.explanations.emplace_back(), AttributesInto(*one));
      read_columns(*one, result.explanations.back());
    }
  if (const auto all = root.group("comparison")) {
    for (int i = 0; const auto one = all->group(std::to_string(i)); ++i) {
      Comparison& comparison = result.comparisons.emplace_back();
      describe(comparison, AttributesInto(*one));
      read_columns(*one, comparison);
    }
  }
  if (const auto group = root.group("timing")) describe(result.timing, AttributesInto(*group));
  if (const auto group = root.group("provenance")) describe(result.provenance, AttributesInto(*group));
  return result;
}

}  // namespace

Result read_run_h5(const std::filesystem::path& file, std::string_view label) {
  const h5::ReadGroup root = h5::open_file(file, label);
  if (!root.has_attribute("schema") || !root.group("runs"))
    throw bad_input("{}'{}' is HDF5, but no run of this program", label.empty() ? "" : std::string(label) + ": ",
                    file.string());
  if (root.number("schema") != summary_schema)
    throw bad_input("{}'{}' has schema {}; this program reads {}", label.empty() ? "" : std::string(label) + ": ",
                    file.string(), root.number("schema"), summary_schema);
  return read_result(root);
}

}  // namespace validate

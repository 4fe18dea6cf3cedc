#include "compare/documents/run_h5.hpp"

#include <fmt/core.h>

#include "compare/base/file.hpp"
#include "compare/documents/bytes/h5.hpp"
#include "compare/documents/fields_h5.hpp"
#include "compare/documents/texts/summary_json.hpp"
#include "compare/results/keys.hpp"

namespace validate {

namespace {

// Each described member becomes an attribute of the group, members of a table an attribute of a group inside
// it. The unit is in the attribute's name.
class AttributesOf {
 public:
  explicit AttributesOf(h5::Group& group) : group_(group) {}

  template <class T>
  void operator()(const Field& field, const T& value) {
    if (field.table.empty()) {
      write(group_, key(field), value);
    } else {
      write(table(field.table), key(field), value);
    }
  }

 private:
  h5::Group& table(std::string_view name) {
    for (auto& [known, group] : tables_) {
      if (known == name) return group;
    }
    return tables_.emplace_back(name, group_.group(name)).second;
  }

  template <class T>
  static void write(h5::Group& group, const std::string& name, const std::optional<T>& value) {
    if (value) write(group, name, *value);
  }
  template <class T>
  static void write(h5::Group& group, const std::string& name, const T& value) {
    if constexpr (std::is_enum_v<T>) {
      group.attribute(name, to_string(value));
    } else {
      group.attribute(name, value);
    }
  }

  h5::Group& group_;
  std::vector<std::pair<std::string_view, h5::Group>> tables_;
};

template <class Struct>
h5::Group write_group(h5::Group& parent, std::string_view name, const Struct& described) {
  h5::Group group = parent.group(name);
  describe_with_twins(described, AttributesOf(group));
  return group;
}

template <class Values>
h5::Object write_column(h5::Group& group, const std::string& name, const Values& values) {
  if constexpr (std::is_enum_v<typename Values::value_type>) {
    std::vector<std::string> texts;
    for (const auto value : values) texts.emplace_back(to_string(value));
    return group.data_set(name, texts);
  } else {
    return group.data_set(name, values);
  }
}

template <class Struct>
void write_columns(h5::Group& group, const Struct& described) {
  describe_points(described, [&group](const Field& field, const auto& values) {
    h5::Object set = write_column(group, key(field), values);
    set.attribute("unit", field.unit);
    set.attribute("meaning", field.meaning);
  });
}

void write_run(h5::Group& runs, std::size_t index, const Run& run) {
  h5::Group group = write_group(runs, fmt::format("{}", index), run);
  write_columns(group, run);
  if (run.contact) write_group(group, "contact", *run.contact);
  if (run.fit) {
    h5::Group fit = write_group(group, "fit", *run.fit);
    write_columns(fit, *run.fit);
    if (run.fit->bias) write_group(fit, "bias", *run.fit->bias);
    if (run.fit->direct) write_group(fit, "direct", *run.fit->direct);
    h5::Group scan = group.group("window_scan");
    write_columns(scan, run.scan);
  } else {
    group.attribute("fit_skipped", run.fit_skipped);
  }
  if (!run.pictures) return;
  h5::Group fields = group.group("fields");
  for (std::size_t i = 0; i < run.pictures->size(); ++i) write_fields(fields, fmt::format("{}", i), (*run.pictures)[i]);
}

void write_result(h5::Group& root, const Result& result) {
  root.attribute("schema", summary_schema);
  root.attribute("meaning", "membrane against atoms: the keys are those of summary.json");
  write_group(root, "case", result.resolved);
  if (result.sheet) write_group(root, "sheet", *result.sheet);
  if (result.card) write_group(root, "card", *result.card);
  h5::Group runs = root.group("runs");
  for (std::size_t i = 0; i < result.runs.size(); ++i) write_run(runs, i, result.runs[i]);
  if (result.agreement) {
    h5::Group agreement = write_group(root, "agreement", *result.agreement);
    write_columns(agreement, *result.agreement);
  } else {
    root.attribute("agreement_skipped", result.agreement_skipped);
  }
  if (result.law) {
    h5::Group law = write_group(root, "law", *result.law);
    write_columns(law, *result.law);
  }
  h5::Group explanations = root.group("explanation");
  for (std::size_t i = 0; i < result.explanations.size(); ++i) {
    h5::Group one = write_group(explanations, fmt::format("{}", i), result.explanations[i]);
    write_columns(one, result.explanations[i]);
  }
  h5::Group comparisons = root.group("comparison");
  for (std::size_t i = 0; i < result.comparisons.size(); ++i) {
    h5::Group one = write_group(comparisons, fmt::format("{}", i), result.comparisons[i]);
    write_columns(one, result.comparisons[i]);
  }
  write_group(root, "timing", result.timing);
  write_group(root, "provenance", result.provenance);
}

}  // namespace

void write_run_h5(const Result& result, const std::filesystem::path& folder) {
  PendingFile pending(folder / "run.h5");
  h5::File file(pending.path());
  write_result(file.root(), result);
  file.close();
  pending.commit();
}

}  // namespace validate

#include "compare/documents/bytes/run_h5.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "compare/base/file.hpp"
#include "compare/base/keys.hpp"
#include "compare/base/walk.hpp"
#include "compare/documents/bytes/fields_h5.hpp"
#include "compare/documents/bytes/h5.hpp"
#include "compare/documents/bytes/trajectory_h5.hpp"

namespace validate {
namespace {

template <Described Struct>
void write_group(h5::Group& parent, std::string_view name, const Struct& s);

void write_value(h5::Group& group, const std::string& name, const Pair& value) {
  group.attribute(name, std::span(value));
}
template <Worded Enum>
void write_value(h5::Group& group, const std::string& name, Enum value) {
  group.attribute(name, to_string(value));
}
template <Worded Enum>
void write_value(h5::Group& group, const std::string& name, const std::vector<Enum>& values) {
  std::vector<std::string> texts;
  for (const Enum value : values) texts.emplace_back(to_string(value));
  group.attribute(name, texts);
}
template <class T>
requires(!Worded<T>) void write_value(h5::Group& group, const std::string& name, const T& value) {
  group.attribute(name, value);
}

template <class T>
h5::Object write_column(h5::Group& group, const std::string& name, const std::vector<T>& values) {
  if constexpr (Worded<T>) {
    std::vector<std::string> texts;
    for (const T value : values) texts.emplace_back(to_string(value));
    return group.data_set(name, texts);
  } else {
    return group.data_set(name, values);
  }
}

/// Adds each described member to a group, members of a table to a group inside it.
class AddTo {
 public:
  explicit AddTo(h5::Group& group) : group_(group) {}

  template <class T>
  void operator()(const Column& field, const std::vector<T>& values) {
    if (values.empty() && field.may_lack) return;
    if (!values.empty() && length_ != 0 && values.size() != length_)
      throw std::logic_error(
          fmt::format("the column {} has {} values beside columns of {}", field.name, values.size(), length_));
    if (!values.empty()) length_ = values.size();
    h5::Object set = write_column(group_, key(field), values);
    set.attribute("unit", field.unit);
    set.attribute("meaning", field.meaning);
  }

  template <Variant Part>
  void operator()(const Field&, const Part& part) {
    std::visit([this](const auto& members) { describe_with_twins(members, *this); }, part);
  }

  void operator()(const Field& field, const std::shared_ptr<const std::vector<SheetPicture>>& pictures) {
    if (!pictures) return;
    h5::Group fields = group_.group(field.name);
    for (std::size_t i = 0; i < pictures->size(); ++i) write_fields(fields, fmt::format("{}", i), (*pictures)[i]);
  }

  void operator()(const Field& field, const std::shared_ptr<const Result>& result) {
    if (result) write_group(group_, field.name, *result);
  }

  template <class T>
  void operator()(const Field& field, const std::optional<T>& value) {
    if (value) (*this)(field, *value);
  }

  template <Described Struct>
  void operator()(const Field& field, const Struct& s) {
    if (!field.may_lack || !lacks(s)) write_group(place(field), field.name, s);
  }

  template <Described Struct>
  void operator()(const Field& field, const std::vector<Struct>& list) {
    h5::Group group = group_.group(field.name);
    for (std::size_t i = 0; i < list.size(); ++i) write_group(group, fmt::format("{}", i), list[i]);
  }

  template <class T>
  void operator()(const Field& field, const T& value) {
    if (!field.may_lack || !lacks(value)) write_value(place(field), key(field), value);
  }

 private:
  h5::Group& place(const Field& field) {
    if (field.table.empty()) return group_;
    for (auto& [known, group] : tables_)
      if (known == field.table) return group;
    return tables_.emplace_back(field.table, group_.group(field.table)).second;
  }

  h5::Group& group_;
  std::vector<std::pair<std::string_view, h5::Group>> tables_;
  std::size_t length_ = 0;
};

template <Described Struct>
void write_group(h5::Group& parent, std::string_view name, const Struct& s) {
  h5::Group group = parent.group(name);
  describe_with_twins(s, AddTo(group));
}

}  // namespace

void write_run_h5(const Result& result, const std::filesystem::path& target,
                  const std::vector<AtomsTrajectory>& trajectories) {
  h5::File file;
  file.root().attribute("meaning", "the keys are those of the command's JSON document");
  describe_with_twins(result, AddTo(file.root()));
  write_trajectories(file.root(), trajectories, result.provenance.version);
  write_file(target, file.image());
}

}  // namespace validate

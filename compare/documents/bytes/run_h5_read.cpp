#include "compare/documents/bytes/run_h5_read.hpp"

#include <fmt/core.h>

#include <limits>

#include "compare/base/errors.hpp"
#include "compare/base/keys.hpp"
#include "compare/base/walk.hpp"
#include "compare/documents/bytes/fields_h5.hpp"
#include "compare/documents/bytes/h5_read.hpp"

namespace validate {
namespace {

template <Worded Enum>
Enum word_from(const std::string& text) {
  if (const auto value = from_word<Enum>(text)) return *value;
  throw bad_input("run.h5 holds the unknown word '{}'", text);
}

template <class T>
T number_as(double value, const std::string& name) {
  if constexpr (std::is_same_v<T, int> || std::is_same_v<T, long>) {
    if (!(value >= static_cast<double>(std::numeric_limits<T>::min()) &&
          value < static_cast<double>(std::numeric_limits<T>::max())))
      throw bad_input("run.h5: '{}' is {}, not a whole number of this program", name, value);
  }
  return static_cast<T>(value);
}

template <Described Struct>
void read_struct(const h5::ReadGroup& group, Struct& s);

/// Reads each described member from where AddTo of run_h5.cpp puts it. What is not there keeps its value.
class ReadFrom {
 public:
  explicit ReadFrom(const h5::ReadGroup& group) : group_(group) {}

  template <class T>
  void operator()(const Column& field, std::vector<T>& values) {
    if constexpr (Worded<T>) {
      for (const std::string& text : group_.text_column(key(field))) values.push_back(word_from<T>(text));
    } else {
      for (const double value : group_.column(key(field))) values.push_back(number_as<T>(value, key(field)));
    }
    if (values.empty()) {
      if (!field.may_lack && missing_.empty()) missing_ = key(field);
      return;
    }
    if (length_ != 0 && values.size() != length_)
      throw bad_input("run.h5: the column '{}' has {} values beside columns of {}", key(field), values.size(), length_);
    length_ = values.size();
  }

  template <Variant Part>
  void operator()(const Field&, Part& part) {
    std::visit([this](auto& members) { describe(members, *this); }, part);
  }

  void operator()(const Field& field, std::shared_ptr<const std::vector<SheetPicture>>& pictures) {
    const auto fields = group_.group(field.name);
    if (!fields) return;
    std::vector<SheetPicture> read;
    for (int i = 0; const auto one = fields->group(std::to_string(i)); ++i) read.push_back(read_fields(*one));
    pictures = std::make_shared<const std::vector<SheetPicture>>(std::move(read));
  }

  void operator()(const Field& field, std::shared_ptr<const Result>& result) {
    const auto group = group_.group(field.name);
    if (!group) return;
    if (group->has_attribute("command") && group->text("command") == to_string(Command::batch))
      throw bad_input("run.h5: a batch in a batch");
    Result read;
    read_struct(*group, read);
    result = std::make_shared<const Result>(std::move(read));
  }

  template <class T>
  void operator()(const Field& field, std::optional<T>& value) {
    if constexpr (Described<T>) {
      if (const auto group = group_.group(field.name)) read_struct(*group, value.emplace());
    } else {
      if (place(field).has_attribute(key(field))) read_value(place(field), key(field), value.emplace());
    }
  }

  template <Described Struct>
  void operator()(const Field& field, Struct& s) {
    if (const auto group = group_.group(field.name)) read_struct(*group, s);
  }

  template <Described Struct>
  void operator()(const Field& field, std::vector<Struct>& list) {
    const auto group = group_.group(field.name);
    if (!group) return;
    for (int i = 0; const auto one = group->group(std::to_string(i)); ++i) read_struct(*one, list.emplace_back());
  }

  template <class T>
  void operator()(const Field& field, T& value) {
    if (place(field).has_attribute(key(field))) read_value(place(field), key(field), value);
  }

  /// To be called once everything is read: columns are there together or not at all.
  void check_columns() const {
    if (length_ != 0 && !missing_.empty())
      throw bad_input("run.h5: the column '{}' is missing beside columns of {}", missing_, length_);
  }

 private:
  const h5::ReadGroup& place(const Field& field) {
    if (field.table.empty()) return group_;
    if (table_name_ != field.table) {
      table_ = group_.group(field.table);
      table_name_ = field.table;
    }
    return table_ ? *table_ : group_;
  }

  static void read_value(const h5::ReadGroup& group, const std::string& name, std::string& value) {
    value = group.text(name);
  }
  static void read_value(const h5::ReadGroup& group, const std::string& name, std::vector<std::string>& value) {
    value = group.texts(name);
  }
  static void read_value(const h5::ReadGroup& group, const std::string& name, std::vector<double>& value) {
    value = group.numbers(name);
  }
  static void read_value(const h5::ReadGroup& group, const std::string& name, Pair& value) {
    const std::vector<double> both = group.numbers(name);
    if (both.size() != 2) throw bad_input("run.h5: '{}' is {} numbers, not two", name, both.size());
    value = {both[0], both[1]};
  }
  template <Worded Enum>
  static void read_value(const h5::ReadGroup& group, const std::string& name, Enum& value) {
    value = word_from<Enum>(group.text(name));
  }
  template <Worded Enum>
  static void read_value(const h5::ReadGroup& group, const std::string& name, std::vector<Enum>& value) {
    value.clear();
    for (const std::string& text : group.texts(name)) value.push_back(word_from<Enum>(text));
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  static void read_value(const h5::ReadGroup& group, const std::string& name, T& value) {
    value = number_as<T>(group.number(name), name);
  }

  const h5::ReadGroup& group_;
  std::optional<h5::ReadGroup> table_;
  std::string_view table_name_;
  std::size_t length_ = 0;
  std::string missing_;
};

template <Described Struct>
void read_struct(const h5::ReadGroup& group, Struct& s) {
  ReadFrom walk(group);
  describe(s, walk);
  walk.check_columns();
}

}  // namespace

Result read_run_h5(const std::filesystem::path& file, std::string_view label) {
  const h5::ReadGroup root = h5::open_file(file, label);
  const std::string start = label.empty() ? "" : std::string(label) + ": ";
  if (!root.has_attribute("schema") || !root.has_attribute("command"))
    throw bad_input(
        "{}'{}' is HDF5, but no result of this program{}", start, file.string(),
        root.has_attribute("schema") ? fmt::format(", or of an older one, schema {}", root.number("schema")) : "");
  if (root.number("schema") != document_schema)
    throw bad_input("{}'{}' has schema {}; this program reads {}", start, file.string(), root.number("schema"),
                    document_schema);
  Result result;
  read_struct(root, result);
  return result;
}

}  // namespace validate

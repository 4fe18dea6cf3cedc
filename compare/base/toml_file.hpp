// A TOML file read into a described struct: describe() gives the keys, units and ranges, this gives file and
// line.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/field_value.hpp"
#include "compare/base/words.hpp"

namespace validate {

class TomlFile {
 public:
  /// Parses the file. Throws Error: bad input with file, line and column where it is not TOML; `label` (a
  /// flag, or the key that names the file) starts the message about a file that cannot be read.
  explicit TomlFile(std::filesystem::path file, std::string_view label = {});
  TomlFile(TomlFile&&) noexcept;
  ~TomlFile();

  /// The tables of [[name]], each read as if it were a file. Throws Error (bad input) where there is none, or anything
  /// else at the top level.
  std::vector<TomlFile> tables(std::string_view name) const;

  /// "file:line" of what this is: a file, or one of its tables.
  std::string where() const;

  /// Overwrites the fields that the file gives and returns their origins. A key that no field has, a value of
  /// the wrong type or outside the field's range throws Error (bad input) with file and line.
  template <class Struct>
  Origins read(Struct& s) {
    std::vector<Field> fields;
    describe(s, [&](const Field& field, const auto&) { fields.push_back(field); });
    refuse_unknown_keys(fields);
    Origins origins;
    describe(s, [&](const Field& field, auto& value) {
      if (const auto label = find(field)) {
        read_value(field, *label, value);
        origins.emplace(field.name, *label);
      }
    });
    return origins;
  }

 private:
  struct Content;  // keeps the TOML library out of every other file
  TomlFile(std::filesystem::path file, std::unique_ptr<const Content> content);

  void refuse_unknown_keys(const std::vector<Field>&) const;
  std::optional<std::string> find(const Field&) const;  // "file:line: key" if the key is given

  void read_value(const Field&, const std::string& label, double&) const;
  void read_value(const Field&, const std::string& label, std::optional<double>&) const;
  void read_value(const Field&, const std::string& label, bool&) const;
  void read_value(const Field&, const std::string& label, std::string&) const;
  void read_value(const Field&, const std::string& label, std::vector<double>&) const;
  void read_value(const Field&, const std::string& label, std::vector<std::string>&) const;
  template <Worded Enum>
  void read_value(const Field& field, const std::string& label, Enum& value) const {
    std::string text;
    read_value(with_words<Enum>(field), label, text);
    value = *from_word<Enum>(text);
  }
  template <Worded Enum>
  void read_value(const Field& field, const std::string& label, std::optional<Enum>& value) const {
    read_value(field, label, value.emplace());
  }
  template <Worded Enum>
  void read_value(const Field& field, const std::string& label, std::vector<Enum>& value) const {
    value.clear();
    for (const std::string& text : texts(with_words<Enum>(field), label)) value.push_back(*from_word<Enum>(text));
  }
  std::vector<std::string> texts(const Field&, const std::string& label) const;

  std::filesystem::path file_;
  std::unique_ptr<const Content> content_;
};

}  // namespace validate

// The reading half of the thin layer over HDF5. A file may come from anybody: class, size and length of everything are
// checked before it is read, and what leads out of the file is refused.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/documents/bytes/h5.hpp"

namespace validate::h5 {

/// An open file and how many values it may still give: one that claims more than it has bytes for, or leads to the same
/// group again and again, is refused before memory is.
struct OpenFile {
  Handle handle;
  std::size_t values_left = 0;
};

/// A data set of numbers with the attributes that say what it holds.
struct NumberSet {
  std::vector<double> values;
  std::string unit, meaning;
  int components = 1;
};

/// Numbers of several dimensions, the last one the fastest.
struct NumberBlock {
  std::vector<std::size_t> shape;
  std::vector<float> values;
};

/// A group opened for reading. Names that are not there are no error where the answer says so; anything else throws
/// Error (file failed): a link that is not to an object of this file, another class than asked for, texts of fixed
/// length, more than one dimension but for blocks, more values than the file can hold.
class ReadGroup {
 public:
  ReadGroup(std::shared_ptr<OpenFile> file, Handle group) : file_(std::move(file)), group_(std::move(group)) {}

  std::optional<ReadGroup> group(std::string_view name) const;

  bool has_attribute(const std::string& name) const;
  double number(const std::string& attribute) const;  ///< of any numeric type, booleans included
  std::vector<double> numbers(const std::string& attribute) const;
  std::string text(const std::string& attribute) const;
  std::vector<std::string> texts(const std::string& attribute) const;
  std::vector<std::string> attribute_names() const;

  // Data sets; empty where there is none of that name.
  std::vector<double> column(const std::string& name) const;
  std::vector<std::string> text_column(const std::string& name) const;
  NumberSet number_set(const std::string& name) const;
  NumberBlock block(const std::string& name) const;
  std::vector<std::string> data_set_names() const;  ///< and of groups

  /// What is of one kind, in the order of creation where the file keeps it, else of the alphabet.
  std::vector<std::string> group_names() const;
  std::vector<std::string> column_names() const;  ///< data sets of one dimension

  /// Whether an attribute is one number, or one text of variable length.
  bool is_number(const std::string& attribute) const;
  bool is_text(const std::string& attribute) const;

 private:
  std::shared_ptr<OpenFile> file_;  // stays open as long as one of its groups
  Handle group_;
};

/// The root of a file. Throws Error: bad input if there is no such file or it is not HDF5; `label` starts the
/// message.
ReadGroup open_file(const std::filesystem::path& file, std::string_view label);

}  // namespace validate::h5

#include "compare/instruments/raw_columns.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace validate {
namespace {

class Packer {
 public:
  void size(std::size_t value) {
    const auto wide = static_cast<std::uint64_t>(value);
    bytes(&wide, sizeof wide);
  }
  void number(double value) { bytes(&value, sizeof value); }
  void text(const std::string& value) {
    size(value.size());
    bytes(value.data(), value.size());
  }
  void numbers(const std::vector<double>& values) {
    size(values.size());
    bytes(values.data(), values.size() * sizeof(double));
  }
  std::string take() { return std::move(out_); }

 private:
  void bytes(const void* from, std::size_t count) { out_.append(static_cast<const char*>(from), count); }

  std::string out_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  std::size_t size() {
    std::uint64_t wide = 0;
    bytes(&wide, sizeof wide);
    if (wide > rest_.size()) throw std::logic_error("a size beyond the end");
    return static_cast<std::size_t>(wide);
  }
  double number() {
    double value = 0;
    bytes(&value, sizeof value);
    return value;
  }
  std::string text() {
    std::string value(size(), '\0');
    bytes(value.data(), value.size());
    return value;
  }
  std::vector<double> numbers() {
    const std::size_t count = size();
    if (count > rest_.size() / sizeof(double)) throw std::logic_error("a list beyond the end");
    std::vector<double> values(count);
    bytes(values.data(), count * sizeof(double));
    return values;
  }

 private:
  void bytes(void* into, std::size_t count) {
    if (count > rest_.size()) throw std::logic_error("beyond the end");
    if (count > 0) std::memcpy(into, rest_.data(), count);
    rest_.remove_prefix(count);
  }

  std::string_view rest_;
};

}  // namespace

std::string packed(const std::vector<RawGroup>& groups) {
  Packer out;
  out.size(groups.size());
  for (const RawGroup& group : groups) {
    out.text(group.name);
    out.size(group.attributes.size());
    for (const auto& [name, value] : group.attributes) {
      out.text(name);
      out.size(value.index());
      if (const auto* number = std::get_if<double>(&value)) out.number(*number);
      if (const auto* text = std::get_if<std::string>(&value)) out.text(*text);
    }
    out.size(group.columns.size());
    for (const RawColumn& column : group.columns) {
      out.text(column.name);
      out.text(column.unit);
      out.numbers(column.values);
    }
  }
  return out.take();
}

std::vector<RawGroup> unpacked(std::string_view bytes) {
  Unpacker in(bytes);
  std::vector<RawGroup> groups;
  for (std::size_t g = in.size(); g > 0; --g) {
    RawGroup& group = groups.emplace_back();
    group.name = in.text();
    for (std::size_t a = in.size(); a > 0; --a) {
      std::string name = in.text();
      if (in.size() == 0)
        group.attributes.emplace_back(std::move(name), in.number());
      else
        group.attributes.emplace_back(std::move(name), in.text());
    }
    for (std::size_t c = in.size(); c > 0; --c) {
      std::string name = in.text(), unit = in.text();
      group.columns.push_back({std::move(name), std::move(unit), in.numbers()});
    }
  }
  return groups;
}

}  // namespace validate

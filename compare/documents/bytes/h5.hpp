// A thin layer over the HDF5 C library: handles that close themselves, and the few kinds of data written
// here.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace validate::h5 {

/// An HDF5 id and the function that closes it.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t get() const { return id_; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Something that carries attributes: a group or a data set. All functions throw Error (file failed).
class Object {
 public:
  explicit Object(Handle handle) : handle_(std::move(handle)) {}

  void attribute(std::string_view name, double value);
  void attribute(std::string_view name, int value);
  void attribute(std::string_view name, long value);
  void attribute(std::string_view name, bool value);
  void attribute(std::string_view name, std::string_view value);
  void attribute(std::string_view name, const char* value) { attribute(name, std::string_view(value)); }
  void attribute(std::string_view name, std::span<const double> values);
  void attribute(std::string_view name, std::span<const int> values);
  void attribute(std::string_view name, std::span<const std::string> values);

 protected:
  Handle handle_;
};

class Group : public Object {
 public:
  using Object::Object;

  Group group(std::string_view name);

  // One-dimensional data sets.
  Object data_set(std::string_view name, std::span<const double> values);
  Object data_set(std::string_view name, std::span<const int> values);
  Object data_set(std::string_view name, const std::vector<bool>& values);
  Object data_set(std::string_view name, std::span<const std::string> values);

  /// Of single precision and several dimensions, the last one the fastest; their product is the number of values.
  Object data_set(std::string_view name, std::span<const float> values, std::span<const std::size_t> shape);
};

/// A new file, in memory alone: the library goes on with a file that it could not write as if it had, and ends the
/// program with it.
class File {
 public:
  File();
  Group& root() { return root_; }
  /// Its bytes; every other object of the file must be gone by then. Throws Error (file failed).
  std::string image();

 private:
  Handle file_;
  Group root_;
};

}  // namespace validate::h5

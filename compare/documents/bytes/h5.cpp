#include "compare/documents/bytes/h5.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>

#include "compare/base/errors.hpp"

namespace validate::h5 {

namespace {

// The innermost message of HDF5's error stack, which says what went wrong with the file.
std::string library_message() {
  std::string message = "HDF5 gives no reason";
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_DOWNWARD,
      [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
        if (error->desc) *static_cast<std::string*>(out) = error->desc;
        return 0;
      },
      &message);
  return message;
}

[[noreturn]] void fail(std::string_view what) {
  throw Error(ExitCode::file_failed, fmt::format("cannot write HDF5 {}: {}", what, library_message()));
}

Handle checked(hid_t id, Handle::Close close, std::string_view what) {
  if (id < 0) fail(what);
  return {id, close};
}

void check(herr_t status, std::string_view what) {
  if (status < 0) fail(what);
}

Handle block_space(std::span<const std::size_t> shape) {
  const std::vector<hsize_t> lengths(shape.begin(), shape.end());
  return checked(H5Screate_simple(static_cast<int>(lengths.size()), lengths.data(), nullptr), H5Sclose, "data space");
}

Handle list_space(std::size_t size) { return block_space({&size, 1}); }

Handle scalar_space() { return checked(H5Screate(H5S_SCALAR), H5Sclose, "data space"); }

Handle text_type() {
  Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, "text type");
  check(H5Tset_size(type.get(), H5T_VARIABLE), "text type");
  check(H5Tset_cset(type.get(), H5T_CSET_UTF8), "text type");
  return type;
}

// The enumeration that h5py reads as bool.
Handle bool_type() {
  Handle type = checked(H5Tenum_create(H5T_NATIVE_INT8), H5Tclose, "bool type");
  const std::int8_t no = 0, yes = 1;
  check(H5Tenum_insert(type.get(), "FALSE", &no), "bool type");
  check(H5Tenum_insert(type.get(), "TRUE", &yes), "bool type");
  return type;
}

void write_attribute(hid_t object, std::string_view name, hid_t type, const Handle& space, const void* data) {
  const std::string owned(name);
  const Handle attribute =
      checked(H5Acreate2(object, owned.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  if (data) check(H5Awrite(attribute.get(), type, data), name);  // an empty list has no address
}

Handle write_data_set(hid_t group, std::string_view name, hid_t type, const Handle& space, const void* data) {
  const std::string owned(name);
  Handle set = checked(H5Dcreate2(group, owned.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose, name);
  if (data) check(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), name);
  return set;
}

// Children are listed in the order in which they were made.
Handle ordered_group_properties(hid_t property_class) {
  Handle properties = checked(H5Pcreate(property_class), H5Pclose, "properties");
  check(H5Pset_link_creation_order(properties.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), "properties");
  check(H5Pset_attr_creation_order(properties.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), "properties");
  return properties;
}

Handle create_file() {
  constexpr std::size_t grows_by_bytes = 1 << 20;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown with a message, not printed
  const Handle properties = ordered_group_properties(H5P_FILE_CREATE);
  const Handle in_memory = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "properties");
  check(H5Pset_fapl_core(in_memory.get(), grows_by_bytes, false), "properties");
  return checked(H5Fcreate("run.h5", H5F_ACC_TRUNC, properties.get(), in_memory.get()), H5Fclose, "file");
}

}  // namespace

void Object::attribute(std::string_view name, double value) {
  write_attribute(handle_.get(), name, H5T_NATIVE_DOUBLE, scalar_space(), &value);
}
void Object::attribute(std::string_view name, int value) {
  write_attribute(handle_.get(), name, H5T_NATIVE_INT, scalar_space(), &value);
}
void Object::attribute(std::string_view name, long value) {
  write_attribute(handle_.get(), name, H5T_NATIVE_LONG, scalar_space(), &value);
}
void Object::attribute(std::string_view name, bool value) {
  const std::int8_t byte = value;
  write_attribute(handle_.get(), name, bool_type().get(), scalar_space(), &byte);
}
void Object::attribute(std::string_view name, std::string_view value) {
  const std::string owned(value);
  const char* const text = owned.c_str();
  write_attribute(handle_.get(), name, text_type().get(), scalar_space(), &text);
}
void Object::attribute(std::string_view name, std::span<const double> values) {
  write_attribute(handle_.get(), name, H5T_NATIVE_DOUBLE, list_space(values.size()), values.data());
}
void Object::attribute(std::string_view name, std::span<const int> values) {
  write_attribute(handle_.get(), name, H5T_NATIVE_INT, list_space(values.size()), values.data());
}
void Object::attribute(std::string_view name, std::span<const std::string> values) {
  std::vector<const char*> texts;
  for (const std::string& value : values) texts.push_back(value.c_str());
  write_attribute(handle_.get(), name, text_type().get(), list_space(texts.size()), texts.data());
}

Group Group::group(std::string_view name) {
  const Handle properties = ordered_group_properties(H5P_GROUP_CREATE);
  const std::string owned(name);
  return Group(
      checked(H5Gcreate2(handle_.get(), owned.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Gclose, name));
}

Object Group::data_set(std::string_view name, std::span<const double> values) {
  return Object(write_data_set(handle_.get(), name, H5T_NATIVE_DOUBLE, list_space(values.size()), values.data()));
}
Object Group::data_set(std::string_view name, std::span<const int> values) {
  return Object(write_data_set(handle_.get(), name, H5T_NATIVE_INT, list_space(values.size()), values.data()));
}
Object Group::data_set(std::string_view name, const std::vector<bool>& values) {
  const std::vector<std::int8_t> bytes(values.begin(), values.end());
  return Object(write_data_set(handle_.get(), name, bool_type().get(), list_space(bytes.size()), bytes.data()));
}

Object Group::data_set(std::string_view name, std::span<const float> values, std::span<const std::size_t> shape) {
  return Object(write_data_set(handle_.get(), name, H5T_NATIVE_FLOAT, block_space(shape), values.data()));
}

Object Group::data_set(std::string_view name, std::span<const std::string> values) {
  std::vector<const char*> texts;
  for (const std::string& value : values) texts.push_back(value.c_str());
  return Object(write_data_set(handle_.get(), name, text_type().get(), list_space(texts.size()), texts.data()));
}

File::File() : file_(create_file()), root_(checked(H5Gopen2(file_.get(), "/", H5P_DEFAULT), H5Gclose, "root group")) {}

std::string File::image() {
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "file");
  const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
  if (size < 0) fail("file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file_.get(), bytes.data(), bytes.size()) != size) fail("file");
  return bytes;
}

}  // namespace validate::h5

#include "compare/documents/bytes/h5_read.hpp"

#include <fmt/core.h>

#include <cstdint>

#include "compare/base/errors.hpp"

namespace validate::h5 {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw Error(ExitCode::file_failed, fmt::format("cannot read HDF5 {}", what));
}

hid_t checked(hid_t id, const std::string& what) {
  if (id < 0) fail(what);
  return id;
}

/// An attribute or a data set: what differs between the two calls.
struct Source {
  Handle handle;
  bool attribute;
  std::string name;

  Handle space() const {
    return {checked(attribute ? H5Aget_space(handle.get()) : H5Dget_space(handle.get()), name), H5Sclose};
  }
  Handle type() const {
    return {checked(attribute ? H5Aget_type(handle.get()) : H5Dget_type(handle.get()), name), H5Tclose};
  }
  std::size_t size() const { return static_cast<std::size_t>(H5Sget_simple_extent_npoints(space().get())); }
  void read(hid_t memory, void* into) const {
    const herr_t status = attribute ? H5Aread(handle.get(), memory, into)
                                    : H5Dread(handle.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, into);
    if (status < 0) fail(name);
  }
};

Source attribute_of(hid_t group, const std::string& name) {
  return {Handle(checked(H5Aopen(group, name.c_str(), H5P_DEFAULT), name), H5Aclose), true, name};
}

std::optional<Source> data_set_of(hid_t group, const std::string& name) {
  if (H5Lexists(group, name.c_str(), H5P_DEFAULT) <= 0) return std::nullopt;
  return Source{Handle(checked(H5Dopen2(group, name.c_str(), H5P_DEFAULT), name), H5Dclose), false, name};
}

std::vector<double> numbers_of(const Source& source) {
  std::vector<double> values(source.size());
  if (values.empty()) return values;
  if (H5Tget_class(source.type().get()) == H5T_ENUM) {  // h5py's booleans
    std::vector<std::int8_t> bytes(values.size());
    source.read(source.type().get(), bytes.data());
    values.assign(bytes.begin(), bytes.end());
  } else {
    source.read(H5T_NATIVE_DOUBLE, values.data());
  }
  return values;
}

std::vector<std::string> texts_of(const Source& source) {
  std::vector<char*> raw(source.size(), nullptr);
  const Handle type = source.type();
  if (!raw.empty()) source.read(type.get(), raw.data());
  std::vector<std::string> texts;
  for (char* text : raw) texts.emplace_back(text ? text : "");
  if (!raw.empty()) H5Dvlen_reclaim(type.get(), source.space().get(), H5P_DEFAULT, raw.data());
  return texts;
}

}  // namespace

std::optional<ReadGroup> ReadGroup::group(std::string_view name) const {
  const std::string owned(name);
  if (H5Lexists(group_.get(), owned.c_str(), H5P_DEFAULT) <= 0) return std::nullopt;
  return ReadGroup(file_, Handle(checked(H5Gopen2(group_.get(), owned.c_str(), H5P_DEFAULT), owned), H5Gclose));
}

bool ReadGroup::has_attribute(const std::string& name) const { return H5Aexists(group_.get(), name.c_str()) > 0; }

double ReadGroup::number(const std::string& attribute) const {
  const std::vector<double> values = numbers(attribute);
  if (values.size() != 1) fail(attribute);
  return values.front();
}

std::vector<double> ReadGroup::numbers(const std::string& attribute) const {
  return numbers_of(attribute_of(group_.get(), attribute));
}

std::string ReadGroup::text(const std::string& attribute) const {
  const std::vector<std::string> values = texts(attribute);
  if (values.size() != 1) fail(attribute);
  return values.front();
}

std::vector<std::string> ReadGroup::texts(const std::string& attribute) const {
  return texts_of(attribute_of(group_.get(), attribute));
}

std::vector<double> ReadGroup::column(const std::string& name) const {
  const auto source = data_set_of(group_.get(), name);
  return source ? numbers_of(*source) : std::vector<double>{};
}

std::vector<std::string> ReadGroup::text_column(const std::string& name) const {
  const auto source = data_set_of(group_.get(), name);
  return source ? texts_of(*source) : std::vector<std::string>{};
}

ReadGroup open_file(const std::filesystem::path& file, std::string_view label) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const std::string start = label.empty() ? "" : std::string(label) + ": ";
  if (!std::filesystem::is_regular_file(file)) throw bad_input("{}there is no file '{}'", start, file.string());
  if (H5Fis_hdf5(file.c_str()) <= 0) throw bad_input("{}'{}' is not an HDF5 file", start, file.string());
  auto handle =
      std::make_shared<Handle>(checked(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), file.string()), H5Fclose);
  Handle root(checked(H5Gopen2(handle->get(), "/", H5P_DEFAULT), "root group"), H5Gclose);
  return {std::move(handle), std::move(root)};
}

}  // namespace validate::h5

#include "compare/documents/bytes/h5_read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "compare/base/errors.hpp"

namespace validate::h5 {
namespace {

[[noreturn]] void cannot_read(const std::string& what) {
  throw Error(ExitCode::file_failed, fmt::format("cannot read HDF5 {}", what));
}

hid_t checked(hid_t id, const std::string& what) {
  if (id < 0) cannot_read(what);
  return id;
}

/// Values that a byte of a file may stand for, in all: this program's files have one in eight bytes, compressed ones
/// more.
constexpr std::size_t values_per_byte = 1;
constexpr std::size_t values_for_a_group = 16;  ///< what reading one takes, as values

void take(OpenFile& file, std::size_t values, const std::string& name) {
  if (values > file.values_left) cannot_read(fmt::format("{}: {} values are more than the file holds", name, values));
  file.values_left -= values;
}

/// An attribute or a data set: what differs between the two calls.
struct Source {
  Handle handle;
  bool attribute;
  std::string name;
  OpenFile* file;

  Handle space() const {
    return {checked(attribute ? H5Aget_space(handle.get()) : H5Dget_space(handle.get()), name), H5Sclose};
  }
  Handle type() const {
    return {checked(attribute ? H5Aget_type(handle.get()) : H5Dget_type(handle.get()), name), H5Tclose};
  }
  std::size_t size(bool of_one_dimension = true) const {
    const Handle extent = space();
    const hssize_t values = H5Sget_simple_extent_npoints(extent.get());
    if (of_one_dimension && H5Sget_simple_extent_ndims(extent.get()) > 1)
      cannot_read(name + ": more than one dimension");
    if (values < 0) cannot_read(name + ": how many values");
    return static_cast<std::size_t>(values);
  }
  /// To be called once, before memory is taken for them.
  std::size_t taken(bool of_one_dimension = true) const {
    const std::size_t values = size(of_one_dimension);
    take(*file, values, name);
    return values;
  }
  void read(hid_t memory, void* into) const {
    const herr_t status = attribute ? H5Aread(handle.get(), memory, into)
                                    : H5Dread(handle.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, into);
    if (status < 0) cannot_read(name);
  }
};

Source attribute_of(OpenFile& file, hid_t group, const std::string& name) {
  return {Handle(checked(H5Aopen(group, name.c_str(), H5P_DEFAULT), name), H5Aclose), true, name, &file};
}

/// Whether a name of the group is there; it has to lead to an object of this file.
bool is_here(hid_t group, const std::string& name) {
  if (H5Lexists(group, name.c_str(), H5P_DEFAULT) <= 0) return false;
  H5L_info_t info;
  if (H5Lget_info(group, name.c_str(), &info, H5P_DEFAULT) < 0 || info.type != H5L_TYPE_HARD)
    cannot_read(name + ": a link that is not to an object of this file");
  return true;
}

std::optional<Source> data_set_of(OpenFile& file, hid_t group, const std::string& name) {
  if (!is_here(group, name)) return std::nullopt;
  Source source{Handle(checked(H5Dopen2(group, name.c_str(), H5P_DEFAULT), name), H5Dclose), false, name, &file};
  const Handle properties(checked(H5Dget_create_plist(source.handle.get()), name), H5Pclose);
  if (H5Pget_external_count(properties.get()) != 0 || H5Pget_layout(properties.get()) == H5D_VIRTUAL)
    cannot_read(name + ": its values are kept in another file");
  return source;
}

/// Names of a group that are no links to elsewhere; others' programs do not keep the order of creation.
std::vector<std::string> hard_links(hid_t group) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t* info, void* list) -> herr_t {
    if (info->type == H5L_TYPE_HARD) static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  for (const H5_index_t order : {H5_INDEX_CRT_ORDER, H5_INDEX_NAME}) {
    names.clear();
    if (H5Literate(group, order, H5_ITER_INC, nullptr, add, &names) >= 0) return names;
  }
  cannot_read("a group's names");
}

H5I_type_t kind_of(hid_t group, const std::string& name) {
  const Handle object(checked(H5Oopen(group, name.c_str(), H5P_DEFAULT), name), H5Oclose);
  return H5Iget_type(object.get());
}

/// Enumerations (h5py's booleans) through the integers that they are kept as.
std::vector<double> enumerators_of(const Source& source, hid_t type) {
  const Handle native(checked(H5Tget_native_type(type, H5T_DIR_ASCEND), source.name), H5Tclose);
  const std::size_t bytes = H5Tget_size(native.get()), count = source.taken();
  if (bytes != 1 && bytes != 2 && bytes != 4 && bytes != 8)
    cannot_read(source.name + ": an enumeration of an odd size");
  std::vector<unsigned char> raw(bytes * count);
  if (count > 0) source.read(native.get(), raw.data());
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, raw.data() + i * bytes, bytes);  // little endian, as every machine that LAMMPS is packaged for
    values[i] = static_cast<double>(bits);
  }
  return values;
}

std::vector<double> numbers_of(const Source& source) {
  const Handle type = source.type();
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind == H5T_ENUM) return enumerators_of(source, type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) cannot_read(source.name + ": not a number");
  std::vector<double> values(source.taken());
  if (!values.empty()) source.read(H5T_NATIVE_DOUBLE, values.data());
  return values;
}

std::vector<std::string> texts_of(const Source& source) {
  const Handle type = source.type();
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) <= 0)
    cannot_read(source.name + ": not a text of variable length");
  std::vector<char*> raw(source.taken(), nullptr);
  const Handle memory(checked(H5Tget_native_type(type.get(), H5T_DIR_ASCEND), source.name), H5Tclose);
  if (!raw.empty()) source.read(memory.get(), raw.data());
  std::vector<std::string> texts;
  for (const char* text : raw) texts.emplace_back(text ? text : "");
  if (!raw.empty()) H5Dvlen_reclaim(memory.get(), source.space().get(), H5P_DEFAULT, raw.data());
  return texts;
}

}  // namespace

std::optional<ReadGroup> ReadGroup::group(std::string_view name) const {
  const std::string owned(name);
  if (!is_here(group_.get(), owned)) return std::nullopt;
  take(*file_, values_for_a_group, owned);
  return ReadGroup(file_, Handle(checked(H5Gopen2(group_.get(), owned.c_str(), H5P_DEFAULT), owned), H5Gclose));
}

bool ReadGroup::has_attribute(const std::string& name) const { return H5Aexists(group_.get(), name.c_str()) > 0; }

double ReadGroup::number(const std::string& attribute) const {
  const std::vector<double> values = numbers(attribute);
  if (values.size() != 1) cannot_read(attribute);
  return values.front();
}

std::vector<double> ReadGroup::numbers(const std::string& attribute) const {
  return numbers_of(attribute_of(*file_, group_.get(), attribute));
}

std::string ReadGroup::text(const std::string& attribute) const {
  const std::vector<std::string> values = texts(attribute);
  if (values.size() != 1) cannot_read(attribute);
  return values.front();
}

std::vector<std::string> ReadGroup::texts(const std::string& attribute) const {
  return texts_of(attribute_of(*file_, group_.get(), attribute));
}

std::vector<double> ReadGroup::column(const std::string& name) const {
  const auto source = data_set_of(*file_, group_.get(), name);
  return source ? numbers_of(*source) : std::vector<double>{};
}

NumberBlock ReadGroup::block(const std::string& name) const {
  const auto source = data_set_of(*file_, group_.get(), name);
  if (!source) return {};
  const H5T_class_t kind = H5Tget_class(source->type().get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) cannot_read(name + ": not a number");
  const Handle extent = source->space();
  std::vector<hsize_t> lengths(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(extent.get()))));
  H5Sget_simple_extent_dims(extent.get(), lengths.data(), nullptr);
  NumberBlock block{{lengths.begin(), lengths.end()}, std::vector<float>(source->taken(false))};
  if (!block.values.empty()) source->read(H5T_NATIVE_FLOAT, block.values.data());
  return block;
}

std::vector<std::string> ReadGroup::text_column(const std::string& name) const {
  const auto source = data_set_of(*file_, group_.get(), name);
  return source ? texts_of(*source) : std::vector<std::string>{};
}

NumberSet ReadGroup::number_set(const std::string& name) const {
  const auto source = data_set_of(*file_, group_.get(), name);
  if (!source) return {};
  NumberSet set{numbers_of(*source), {}, {}, 1};
  const auto text = [&](const char* attribute, std::string& into) {
    if (H5Aexists(source->handle.get(), attribute) <= 0) return;
    const auto texts = texts_of(attribute_of(*file_, source->handle.get(), attribute));
    if (texts.size() == 1) into = texts.front();
  };
  text("unit", set.unit);
  text("meaning", set.meaning);
  if (H5Aexists(source->handle.get(), "components") > 0) {
    const auto components = numbers_of(attribute_of(*file_, source->handle.get(), "components"));
    if (components.size() != 1 || !(components[0] >= 1 && components[0] <= 9)) cannot_read(name + ": components");
    set.components = static_cast<int>(components[0]);
  }
  return set;
}

std::vector<std::string> ReadGroup::data_set_names() const { return hard_links(group_.get()); }

std::vector<std::string> ReadGroup::group_names() const {
  std::vector<std::string> names = hard_links(group_.get());
  std::erase_if(names, [this](const std::string& name) { return kind_of(group_.get(), name) != H5I_GROUP; });
  return names;
}

std::vector<std::string> ReadGroup::column_names() const {
  std::vector<std::string> names = hard_links(group_.get());
  std::erase_if(names, [this](const std::string& name) {
    if (kind_of(group_.get(), name) != H5I_DATASET) return true;
    const auto source = data_set_of(*file_, group_.get(), name);
    const Handle extent = source->space(), type = source->type();
    const H5T_class_t kind = H5Tget_class(type.get());
    return H5Sget_simple_extent_ndims(extent.get()) != 1 ||
           (kind != H5T_FLOAT && kind != H5T_INTEGER && kind != H5T_ENUM);
  });
  return names;
}

bool ReadGroup::is_number(const std::string& attribute) const {
  const Source source = attribute_of(*file_, group_.get(), attribute);
  const Handle type = source.type();
  const H5T_class_t kind = H5Tget_class(type.get());
  return source.size() == 1 && (kind == H5T_FLOAT || kind == H5T_INTEGER || kind == H5T_ENUM);
}

bool ReadGroup::is_text(const std::string& attribute) const {
  const Source source = attribute_of(*file_, group_.get(), attribute);
  const Handle type = source.type();
  return H5Tget_class(type.get()) == H5T_STRING && H5Tis_variable_str(type.get()) > 0 && source.size() == 1;
}

std::vector<std::string> ReadGroup::attribute_names() const {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  for (const H5_index_t order : {H5_INDEX_CRT_ORDER, H5_INDEX_NAME}) {
    names.clear();
    if (H5Aiterate2(group_.get(), order, H5_ITER_INC, nullptr, add, &names) >= 0) return names;
  }
  cannot_read("a group's attributes");
}

ReadGroup open_file(const std::filesystem::path& file, std::string_view label) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);  // no filter that a file asks for is loaded from elsewhere
  const std::string start = label.empty() ? "" : std::string(label) + ": ";
  if (!std::filesystem::is_regular_file(file)) throw bad_input("{}there is no file '{}'", start, file.string());
  if (H5Fis_hdf5(file.c_str()) <= 0) throw bad_input("{}'{}' is not an HDF5 file", start, file.string());
  auto open = std::make_shared<OpenFile>(
      OpenFile{{checked(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), file.string()), H5Fclose},
               values_per_byte * std::filesystem::file_size(file)});
  Handle root(checked(H5Gopen2(open->handle.get(), "/", H5P_DEFAULT), "root group"), H5Gclose);
  return {std::move(open), std::move(root)};
}

}  // namespace validate::h5

#include "compare/documents/bytes/recording_h5.hpp"

#include <fmt/format.h>

#include "compare/base/file.hpp"
#include "compare/base/keys.hpp"
#include "compare/base/walk.hpp"
#include "compare/documents/bytes/h5.hpp"

namespace validate {
namespace {

void write_metadata(h5::Group& group, const Recording& recording) {
  group.attribute("file", std::string_view(recording.file));
  group.attribute("index", recording.index);
  describe(recording.metadata, [&](const Field& field, const auto& member) {
    if (lacks(member)) return;
    if constexpr (Optional<std::remove_cvref_t<decltype(member)>>)
      group.attribute(key(field), *member);
    else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, std::string>)
      group.attribute(key(field), std::string_view(member));
    else
      group.attribute(key(field), member);
  });
}

void write_columns(h5::Group& group, const Recording& recording) {
  const auto write = [&group](std::string_view name, const std::string& unit, const std::vector<double>& values) {
    group.data_set(name, values).attribute("unit", std::string_view(unit));
  };
  describe(recording.columns, [&](const Field& field, const std::optional<RecordedColumn>& column) {
    if (column) write(field.name, column->unit, column->values);
  });
  for (const OtherColumn& other : recording.other_columns) {
    std::string name = other.name;
    for (char& c : name)
      if (c == '/') c = '_';  // would be a group
    write(name, other.unit, other.values);
  }
  std::vector<int> segment;
  std::vector<std::string> kinds;
  for (std::size_t s = 0; s < recording.segments.size(); ++s) {
    segment.insert(segment.end(), static_cast<std::size_t>(recording.segments[s].points), static_cast<int>(s));
    kinds.emplace_back(to_string(recording.segments[s].kind));
  }
  group.data_set("segment", segment).attribute("kinds", kinds);
}

}  // namespace

void write_recordings_h5(const std::vector<Recording>& recordings, const std::filesystem::path& file) {
  h5::File out;
  out.root().attribute("software", std::string_view("validate"));
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    h5::Group group = out.root().group(fmt::format("{}", i));
    write_metadata(group, recordings[i]);
    write_columns(group, recordings[i]);
  }
  write_file(file, out.image());
}

}  // namespace validate

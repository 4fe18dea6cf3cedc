#include "atomistic/protocol/heat_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "atomistic/protocol/json.hpp"

namespace atomistic {
namespace {

namespace fs = std::filesystem;

fs::path json_file(const fs::path& folder, const char* kind, int level) {
  return folder / fmt::format("{}-{:04d}.json", kind, level);
}

void write_json(const nlohmann::json& j, const fs::path& final_name) {
  const fs::path temporary = final_name.string() + ".part";
  std::ofstream out(temporary);
  out << j.dump() << '\n';
  if (!out.flush()) throw std::system_error(errno, std::generic_category(), "cannot write " + temporary.string());
  out.close();
  fs::rename(temporary, final_name);
}

template <class Struct>
std::optional<Struct> read_json(const fs::path& file) {
  std::ifstream in(file);
  const auto j = nlohmann::json::parse(in, nullptr, false);
  if (!j.is_object()) return std::nullopt;
  try {
    return j.get<Struct>();
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

void write_heated_level(const HeatedLevel& level, const fs::path& folder) {
  write_json(level, json_file(folder, "heat", level.level));
}

std::optional<HeatedLevel> read_heated_level(int level, const fs::path& folder) {
  return read_json<HeatedLevel>(json_file(folder, "heat", level));
}

void write_sampled(const Sampled& sampled, const fs::path& folder) {
  write_json(sampled, json_file(folder, "sample", sampled.level));
}

std::optional<Sampled> read_sampled(int level, const fs::path& folder) {
  return read_json<Sampled>(json_file(folder, "sample", level));
}

}  // namespace atomistic

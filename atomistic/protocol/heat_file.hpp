// What a temperature does to a level, as files beside the level's step.
#pragma once

#include <filesystem>
#include <optional>

#include "atomistic/temperature.hpp"

namespace atomistic {

/// `heat-0007.json` for level 7, written beside its final name and renamed. Throws std::system_error with the file's
/// name.
void write_heated_level(const HeatedLevel& level, const std::filesystem::path& folder);

/// Nothing where there is no such file or it is damaged.
std::optional<HeatedLevel> read_heated_level(int level, const std::filesystem::path& folder);

/// The same of `sample-0007.json`.
void write_sampled(const Sampled& sampled, const std::filesystem::path& folder);
std::optional<Sampled> read_sampled(int level, const std::filesystem::path& folder);

}  // namespace atomistic

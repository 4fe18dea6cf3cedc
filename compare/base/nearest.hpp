// Nearest valid name, for messages about a name that is not valid.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace validate {

/// The candidate with the fewest typing errors away from `name` (letter case is free); none if all are far.
std::optional<std::string_view> nearest(std::string_view name, std::span<const std::string_view> candidates);

/// "; did you mean 'disc'?", or nothing where no candidate is near.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace validate

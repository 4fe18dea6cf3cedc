// Work for a library that a damaged file can bring down: done in a process of its own.
#pragma once

#include <functional>
#include <string>

namespace validate {

/// What `work` returns, from a child of this process. An Error that it throws is thrown here; where the child ends
/// otherwise, takes more than 2 GiB or a minute of computing, or returns more than `most_bytes`, an Error (bad input)
/// says that the file is damaged, which `label` starts.
std::string done_apart(const std::function<std::string()>& work, std::size_t most_bytes, const std::string& label);

}  // namespace validate

// One finished level as a binary file: all that a later level or a resumed run uses.
#pragma once

#include <filesystem>
#include <vector>

#include "atomistic/problem.hpp"

namespace atomistic {

/// `step-0007.bin` for level 7.
std::filesystem::path step_file_name(int level);

/// Written beside its final name, synchronised with the disk, renamed. Throws std::system_error with the
/// file's name.
void write_step(const Step& step, const std::filesystem::path& folder);

/// Throws std::runtime_error naming the file if it is not a complete step, or one of its bytes has changed.
Step read_step(const std::filesystem::path& file);

/// The levels 0, 1, 2, … that the folder holds without a gap, up to the first that is damaged. Of the vectors only
/// those that a path goes on from: the last step's, and the positions of the last few that it was borne in.
std::vector<Step> read_finished_steps(const std::filesystem::path& folder);

/// Those of the way there, up to the deepest, without the search for a break: the positions of all, all vectors of the
/// deepest.
std::vector<Step> read_way_there(const std::filesystem::path& folder);

/// Those of them that are equilibria.
std::vector<Step> read_equilibria(const std::filesystem::path& folder);

}  // namespace atomistic

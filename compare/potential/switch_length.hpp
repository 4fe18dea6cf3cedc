// The usual cure of the cut-off artefact: a copy of the parameter file with the carbon–carbon switch moved outwards.
#pragma once

#include <string>
#include <string_view>

#include "compare/input/potential_file.hpp"
#include "compare/process/document_folder.hpp"

namespace validate {

/// Refuses a potential whose description names no switch_parameter. Throws Error (bad input).
void check_switch(const PotentialFile& potential, std::string_view label);

/// The potential with its switch at length_A: a copy of the parameter file, published in `folder`, in which the value
/// of switch_parameter alone is changed; the artefact length moves along, `edit` tells what was done. The original file
/// is not touched. Throws Error: bad input where the file does not hold the parameter once, file failed.
PotentialFile with_switch_at(const PotentialFile& potential, double length_A, DocumentFolder& folder,
                             std::string_view label);

}  // namespace validate

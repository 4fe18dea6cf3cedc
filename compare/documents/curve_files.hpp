// The documents of `validate curve`.
#pragma once

#include <filesystem>

#include "compare/results/result.hpp"

namespace validate {

/// What is written of recorded curves.
struct CurveDocuments {
  bool json = true, csv = true, h5 = true, picture = true;
};

/// curve.json, curves.h5, and for each curve curve-<name>[-<index>].csv, .svg and .png in an existing folder. Throws
/// Error (file failed).
void write_curve_files(const Result& result, const std::filesystem::path& folder, const CurveDocuments& which);

}  // namespace validate

// A solved sheet for ParaView: one VTU file a step, and a PVD file that puts them in order.
#pragma once

#include <filesystem>
#include <vector>

#include "compare/results/sheet_columns.hpp"

namespace validate {

/// Points are the deformed positions in Å; every column goes along under its key. Throws Error (file failed).
void write_vtu(const SheetPicture& picture, const std::filesystem::path& file);

/// NAME.pvd in `folder`, with NAME-0.vtu, NAME-1.vtu, …; the level is ParaView's time. Throws Error (file failed).
void write_pvd(const std::vector<SheetPicture>& pictures, const std::filesystem::path& folder, const std::string& name);

}  // namespace validate

// Fields over a sheet seen from above, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/results/sheet_columns.hpp"

namespace validate {

/// One field of one sheet. A quarter is drawn with its mirror images; the wrinkled zone is outlined by the colours of
/// the column "state", which also gets tension rays.
struct FieldPanel {
  std::string title;
  const SheetPicture* picture = nullptr;
  std::string key;                  ///< a column of the triangles
  std::optional<double> low, high;  ///< colour range; the field's own where not given
};

/// NAME.svg and NAME.png in `folder`, panels side by side; a warning where gnuplot is missing or complains. Throws
/// Error (file failed).
std::optional<std::string> draw_fields(const std::vector<FieldPanel>& panels, const std::filesystem::path& folder,
                                       const std::string& name);

}  // namespace validate

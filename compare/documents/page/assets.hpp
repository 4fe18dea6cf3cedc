// Style and script of a page, as style.css and script/ hold them; the build makes their definitions.
#pragma once

#include <string_view>

namespace validate {

extern const std::string_view page_style, page_script;

}  // namespace validate

// A whole page: style for screen, phone and paper, script, and the data that the script draws; nothing is loaded from
// anywhere, and the page itself forbids it.
#pragma once

#include <string>
#include <string_view>

namespace validate {

/// `body` is markup; `data` is JSON, whatever texts are in it, or empty for a page that draws nothing.
std::string page(std::string_view title, std::string_view body, std::string_view data);

}  // namespace validate

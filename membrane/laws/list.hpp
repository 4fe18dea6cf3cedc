// Every material law. A new one is a file beside this one and a name here; the tests run over this list.
#pragma once

#include <variant>

#include "membrane/laws/st_venant_kirchhoff.hpp"

namespace membrane {

using Law = std::variant<StVenantKirchhoff>;

}  // namespace membrane

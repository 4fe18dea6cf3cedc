// What a sheet that cannot bear compression does at a strain.
#pragma once

namespace membrane {

enum class SheetState { taut, wrinkled, slack };

}  // namespace membrane

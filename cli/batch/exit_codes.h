#pragma once
// Exit codes that a batch alone has (docs/FORMATS.md lists all).

#include "bake/error.h"

namespace reliefbake {

constexpr ErrorCode partial_failure = ErrorCode(3); ///< it finished, and some assets failed
constexpr ErrorCode folder_is_busy = ErrorCode(75); ///< another run holds the folder

} // namespace reliefbake

#pragma once
// The command that bakes a representation.

#include "cli/tradeoff/candidate.h"

#include <string>

namespace reliefbake {

/// Command and options without IN, -o and what says how heights are read: "cone --kind relaxed --bits 8 --encoding sqrt". Of the
/// representations of plan_advice.
std::string bake_command_text(const Representation& map);

/// How render, verify and a shader follow it: "--technique relaxed --steps 15 --binary-steps 8".
std::string march_text(const March& march);

} // namespace reliefbake

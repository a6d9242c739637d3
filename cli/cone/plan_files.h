#pragma once
// The files that a run of cones writes.

#include "cli/cone/cone_options.h"

#include <filesystem>
#include <vector>

namespace reliefbake {

/// Of each map of a plan: its own, and the relief beside it.
std::vector<std::vector<std::filesystem::path>> files_of(const ConePlan& plan);

} // namespace reliefbake

#pragma once
// --channels: which planes a map of one cone a texel holds.

#include "cli/cone/cone_options.h"

namespace reliefbake {

void add_channels_option(CLI::App& app, ConeCommandOptions& options);

/// Refuses (usage) options about cones that are left out, and about normals likewise.
Result<void> check_channels(const CLI::App& app, const ConeCommandOptions& options);

} // namespace reliefbake

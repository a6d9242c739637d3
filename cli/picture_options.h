#pragma once
// What a picture of a plane shows, and its shadows: shared by `render` and `bench render`.

#include "cli/command.h"
#include "shaders-reference/renderer/relief_renderer.h"

namespace reliefbake {

/// --view --azimuth --span --sun-azimuth --sun-elevation --tiles --endless --size --supersample
void add_view_options(CLI::App& app, RenderOptions& picture);

/// --shadow --shadow-steps
void add_shadow_options(CLI::App& app, RenderOptions& picture);

/// Refuses (usage) --shadow-steps where nothing marches to the sun.
Result<void> check_shadow_options(const CLI::App& app, const RenderOptions& picture);

} // namespace reliefbake

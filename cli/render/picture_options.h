#pragma once
// What a picture of a plane shows, and its shadows: shared by `render` and `bench render`.

#include "cli/command.h"
#include "cli/options/technique_options.h"

namespace reliefbake {

/// --view --azimuth --span --sun-azimuth --sun-elevation --tiles --endless --size --supersample
void add_view_options(CLI::App& app, RenderOptions& picture);

/// --shadow --shadow-steps
void add_shadow_options(CLI::App& app, RenderOptions& picture);

/// The picture as given, followed by the technique. Refuses (usage) views of planes from 90 degrees on, --endless and --tiles of a map that
/// does not repeat, --shadow-steps where nothing marches to the sun; what resolve_technique refuses.
Result<RenderOptions> plane_picture(const CLI::App& app, const RenderOptions& given, const TechniqueOptions& technique, const ReliefMap& map);

} // namespace reliefbake

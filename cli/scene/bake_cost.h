#pragma once
// How long a map takes, before it is baked.

#include "cli/scene/scene_plan.h"

namespace reliefbake {

/// Nanoseconds of one texel of all levels (of a mesh: one vertex), reading and writing included, as `reliefbake bench scene` prints them.
struct BakeCost {
    const char* what; ///< SceneMap::what
    double nanoseconds;
};

/// The constants of predictions: means over the bundled example, on the machine that docs/SCENE.md names. Other machines and steeper heights differ.
double nanoseconds_of(const std::string& what);

double predicted_seconds(const SceneMap& map);

} // namespace reliefbake

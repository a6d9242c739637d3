#pragma once
// How long a map takes, before it is baked.

#include "cli/scene/scene_plan.h"

namespace reliefbake {

/// Nanoseconds of one texel of all levels (of a mesh: one vertex), reading and writing included, as `reliefbake bench scene` prints them.
struct BakeCost {
    const char* what; ///< SceneMap::what
    double nanoseconds;
};

/// The constants of predictions, measured once (`reliefbake bench scene` measures them anew). Machines, sizes and heights differ.
double nanoseconds_of(const std::string& what);

double predicted_seconds(const SceneMap& map);

} // namespace reliefbake

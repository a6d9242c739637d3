#pragma once
// The ways to follow a ray, and what each needs.

#include "bake/relief_map.h"

#include <span>
#include <string_view>
#include <vector>

namespace reliefbake {

/// How a ray is followed. `given` shades hits that were computed elsewhere.
enum class Technique {
    cone,             ///< conservative and hybrid cones
    cone_published,   ///< the step of 000's Algorithm 7 as printed
    cone_raw,         ///< unfiltered cones, the least of four texels (001 sec. 4.3.1)
    relaxed,          ///< relaxed cones, then halving
    relaxed_secant,   ///< relaxed cones, then secants
    linear,
    binary,           ///< linear, then halving
    interval,         ///< linear, then secants
    dynamic,          ///< binary with fewer steps seen from above
    pom,              ///< parallax occlusion mapping: linear, then one secant unseen
    steep,            ///< steep parallax: linear with more steps at grazing views
    parallax,
    parallax_limited, ///< with offset limiting
    max_mip,          ///< maximum mipmaps; exact, needs no cones
    given,
};

struct TechniqueInfo {
    enum class Steps { none, march, linear };

    Technique technique;
    std::string_view word;                ///< for --technique; empty: not for users
    std::string_view function;            ///< its GLSL function
    std::vector<std::string_view> files;  ///< of glsl/, after relief_map.glsl and relief_cones.glsl
    bool cones;                           ///< reads them
    Steps steps;                          ///< what --steps counts
    int default_steps;                    ///< what its paper uses; for exact marches plenty
    bool refines;                         ///< --binary-steps: halvings or secants
};

std::span<const TechniqueInfo> all_techniques();
const TechniqueInfo& technique_info(Technique technique);

/// What suits a map: relaxed cones need a refining search, conservative and hybrid ones do not, a map without cones is
/// followed exactly.
Technique suitable_technique(const ReliefMap& map);

inline bool has_cones(const ReliefMap& map) { return !map.cone.empty() || !map.cone_planes.empty(); }

} // namespace reliefbake

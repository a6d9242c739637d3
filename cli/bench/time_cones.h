#pragma once
// Timing of the cone bake and of its peers.

#include "bake/acm_adaptive.h"
#include "bake/cone.h"
#include "cli/bench/peers.h"

#include <nlohmann/json.hpp>

namespace reliefbake {

/// How many cones a texel has.
struct ConeCounts {
    int sectors = 1, levels = 1;
    bool pieces = false; ///< the levels are pieces of one cone
};

/// Nanoseconds per texel, of the fastest of `repeat` bakes stage by stage. Keys: search_ns_per_texel (the whole cone
/// search: near + pyramid + far), near_ns_per_texel, pyramid_ns_per_texel, far_ns_per_texel, node_tests_per_texel.
nlohmann::json time_bake(const DepthMap& depth, const ConeOptions& options, const ConeCounts& counts, int repeat);

/// 002's original ring search and its Algorithm 1. Keys of each: name, ns_per_texel, too_wide (share of texel cones that
/// hold the texel centre that limits the ring search's).
nlohmann::json time_adaptive(const DepthMap& depth, AdaptiveOptions adaptive, const ConeOptions& options);

/// ns per texel of a peer, from as many evenly spread texels as fit in about `seconds`. Keys: name, source,
/// ns_per_texel, texels.
nlohmann::json time_peer(const Peer& peer, const DepthMap& depth, float ratio_max, double seconds);

} // namespace reliefbake

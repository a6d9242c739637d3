#pragma once
// Timing of the cone bake and of its peers.

#include "bake/cone.h"
#include "cli/bench/peers.h"

#include <nlohmann/json.hpp>

namespace reliefbake {

/// Nanoseconds per texel, of the fastest of `repeat` bakes stage by stage. Keys: search_ns_per_texel (the whole cone
/// search: near + pyramid + far), near_ns_per_texel, pyramid_ns_per_texel, far_ns_per_texel, node_tests_per_texel.
nlohmann::json time_bake(const DepthMap& depth, const ConeOptions& options, int sectors, int levels, int repeat);

/// ns per texel of a peer, from as many evenly spread texels as fit in about `seconds`. Keys: name, source,
/// ns_per_texel, texels.
nlohmann::json time_peer(const Peer& peer, const DepthMap& depth, float ratio_max, double seconds);

} // namespace reliefbake

#pragma once
// How others bake cone maps, for timing and for counting what their cones get wrong. All scalar, all for the L2 metric.

#include "bake/cone.h"
#include "bake/height_field.h"
#include "bake/image.h"

#include <functional>
#include <string>
#include <vector>

namespace reliefbake {

/// Cone ratio of one texel, at most ratio_max.
using TexelBaker = std::function<float(int x, int y)>;

struct Peer {
    std::string word; ///< for options
    std::string name;
    std::string source;
    ConeFamily family; ///< what its cones are for
    /// Does the work that all texels share, and returns the rest. The depth must outlive the baker.
    std::function<TexelBaker(const DepthMap& depth, float ratio_max)> prepare;
};

/// Brute force: every texel against every other (Dummer 2006).
Peer brute_force_peer();
/// Expanding square rings that stop when no higher texel can be near enough: the published way (002 sec. II-B).
Peer expanding_ring_peer();
/// The 3 x 3 neighbours on every level of a max mip pyramid (Valasek & Ban 2022): fast, narrower than exact.
Peer quick_cone_map_peer();

/// Relaxed cones as GPU Gems 3, chapter 18, samples them: from each texel's top through every other texel, in 128 steps to
/// where the ray leaves the relief again (Policarpo & Oliveira 2007).
Peer sampled_relaxed_peer();

/// All of them.
const std::vector<Peer>& all_peers();

/// Every texel's cone, on `threads` threads; the same for any number of them.
Image<float> bake_peer(const Peer& peer, const DepthMap& depth, float ratio_max, int threads);

} // namespace reliefbake

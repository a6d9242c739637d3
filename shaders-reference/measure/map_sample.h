#pragma once
// What a sampler returns for a map, with exact weights.

#include "bake/relief_map.h"

namespace reliefbake {

enum class Fetch {
    bilinear,
    nearest,
    cell, ///< ConeLookup::cell: the code of the cell, beside the filtered depth
};

/// A channel at (u, v), filtered bilinearly.
double filtered_code(const Image<float>& channel, const TexelGrid& grid, double u, double v);

/// Cone ratio that a shader decodes at (u, v) from one of the map's planes of codes: they are filtered, then decoded.
double sampled_ratio(const ReliefMap& map, const Image<float>& codes, double u, double v, Fetch fetch);

/// Of a map of kind cone.
inline double sampled_ratio(const ReliefMap& map, double u, double v, Fetch fetch) {
    return sampled_ratio(map, map.cone, u, v, fetch);
}

} // namespace reliefbake

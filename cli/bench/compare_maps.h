#pragma once
// What safety costs, and what it buys: maps of one surface by several methods, judged by one verifier.

#include "bake/cone.h"
#include "bake/error.h"

#include <nlohmann/json.hpp>

namespace reliefbake {

/// An array, one object a method: method, violations and points (cones that hold surface), missed (share of rays), steps_mean,
/// steps_max, tightness, bake_ns_per_texel. Methods: ours bilinear L2 and L1, texel cones, their 3x3 minimum (Ban et
/// al. 2024), and on maps of up to 256 x 256 the expanding ring and the quick cone map. Float ratios, so that no encoding
/// hides anything. Errors: as verify (no renderer).
Result<nlohmann::json> compare_maps(const DepthMap& depth, const ConeOptions& options);

} // namespace reliefbake

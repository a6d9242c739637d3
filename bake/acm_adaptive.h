#pragma once
// The published adaptive bake of anisotropic cones (002, Algorithm 1): approximate, kept to be measured.

#include "bake/cone.h"

#include <vector>

namespace reliefbake {

struct AdaptiveOptions {
    int sectors = 4;          ///< 4 or 8 (--sectors)
    int levels = 3;           ///< of the max pyramid above the map; 0 is the original ring search (--levels)
    double similarity = 0.05; ///< a texel this close to its parent in height copies the parent's cones (--similarity)
    friend bool operator==(const AdaptiveOptions&, const AdaptiveOptions&) = default;
};

/// Texel cones per sector: on the coarsest level by expanding rings with early-out (002 sec. II-B, II-C), then downwards, copied
/// where a texel is similar to its parent, else searched from the parent's cones on. No guarantee: a low texel beside a high one
/// sees a slope that its parent does not (MATHS section 4, erratum). `options`: ratio_max and threads are read.
std::vector<ConeMap> bake_sector_cones_adaptive(const DepthMap& depth, const AdaptiveOptions& adaptive, const ConeOptions& options);

} // namespace reliefbake

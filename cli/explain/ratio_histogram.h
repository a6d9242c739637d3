#pragma once
// How wide the cones of a map are: a histogram of decoded cone ratios (002 fig. 2).

#include "bake/error.h"
#include "bake/relief_map.h"

#include <nlohmann/json.hpp>

#include <string>

namespace reliefbake {

/// Ratios in `bins` bins of width 1/bins from 0 to 1, and `wider` above. Of a map with several cones a texel three: `each` cone,
/// the `mean` and the `widest` of each texel's cones. Each is {counts, wider, mean}; the mean takes ratios above 1e6 for 1e6.
/// Errors: usage, when the map holds no cones, or radii (encoding `radius`) without the depth that they are ratios to.
Result<nlohmann::ordered_json> ratio_histogram(const std::string& file, const ReliefMap& map, int bins);

} // namespace reliefbake

#pragma once
// What a sweep is of: a height map, or a baked map.

#include "bake/relief_map.h"
#include "cli/cone/stored_height.h"
#include "cli/tradeoff/candidate.h"

#include <optional>
#include <string>

namespace reliefbake {

struct TradeoffInput {
    std::string file;
    std::string hash; ///< of all pixels and options that decide the surface and its maps
    int width = 0, height = 0;
    std::optional<BakeSource> source; ///< of a height map
    std::optional<ReliefMap> map;     ///< of a baked one
};

/// Reads a baked map, which says so itself, or a height map as `given` says. `crop`: side of the square in the middle that is taken of
/// heights, which does not repeat; 0: all.
/// Errors: those of read_source, read_map; usage (a crop of a baked map; one larger than the map; a kind that is not followed).
Result<TradeoffInput> read_tradeoff_input(const ConeCommandOptions& given, int crop);

/// How a baked map is stored.
Representation stored_representation(const ReliefMap& map);

} // namespace reliefbake

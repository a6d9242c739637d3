#pragma once
// Bit depths and resolutions that an asset's budgets allow, from what was measured on its heights.

#include "bake/bit_depth.h"
#include "bake/error.h"
#include "cli/scene/scene.h"

#include <functional>

namespace reliefbake {

/// A source's heights, and how far a stored surface is off them at the centres of the source's texels.
struct HeightFacts {
    int width = 0, height = 0;
    std::function<double(BitDepth bits, int level)> error; ///< largest; asked for as little as possible
};

/// Half a code of 16 bits: what an asset without a budget is stored with.
constexpr double default_height_budget = 0.5 / 65535;

/// Height that the stored surface may be off. max_shift pixels are max_shift / (depth_scale * screen * sin(angle)) of the relief's depth:
/// what moves a hit so far across the line of sight; with the feature depth the distance to the eye may be off by as much, and
/// 1 / cos(angle) stands for the sine.
double height_budget(const SceneAsset& asset);

struct BitsChoice {
    BitDepth bits = BitDepth::unorm16;
    double error = 0; ///< of the heights at level 0
};

/// The fewest bits whose error is in the budget: 8, 16, or float in a .tif; 16 without a budget, or 8 where they lose nothing.
/// Errors (budget): none of them.
Result<BitsChoice> choose_bits(const SceneAsset& asset, const HeightFacts& facts, const std::string& extension, const std::string& place);

/// The coarsest mip level that has a texel for each pixel (screen) or as many a metre as texel_density says; 0 where the asset says neither.
int seen_level(const SceneAsset& asset, int width, int height);

/// seen_level, or a finer one where max_error or max_shift want it.
int choose_level(const SceneAsset& asset, const HeightFacts& facts, BitDepth bits);

} // namespace reliefbake

#include "cli/scene/choose.h"

#include "cli/report/format_text.h"
#include "cli/scene/map_need.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefbake {

double height_budget(const SceneAsset& asset) {
    if (asset.max_error) return *asset.max_error;
    if (!asset.max_shift) return default_height_budget;
    const double angle = *asset.angle * std::numbers::pi / 180;
    const double pixels = *asset.screen * depth_scale_of(asset) * (asset.features.depth ? 1 / std::cos(angle) : std::sin(angle));
    return *asset.max_shift / pixels;
}

Result<BitsChoice> choose_bits(const SceneAsset& asset, const HeightFacts& facts, const std::string& extension, const std::string& place) {
    const double budget = height_budget(asset);
    const bool floats = extension == ".tif", told = asset.max_error || asset.max_shift;
    const double coarse = facts.error(BitDepth::unorm8, 0);
    if (coarse <= budget) return BitsChoice{BitDepth::unorm8, coarse};
    const double fine = facts.error(BitDepth::unorm16, 0);
    if (fine <= budget || !told) return BitsChoice{BitDepth::unorm16, fine};
    const double finest = floats ? facts.error(BitDepth::float32, 0) : fine;
    if (floats && finest <= budget) return BitsChoice{BitDepth::float32, finest};
    return fail(ErrorCode::budget, place + ": " + (asset.max_error ? "max_error" : "max_shift") + ": heights may be off by " + digits(budget) + " and are by " + format("%.3g", finest) + (floats ? " as floats; allow more" : " in 16 bits; allow more, or write format = \"tif\", which holds floats"));
}

int seen_level(const SceneAsset& asset, int width, int height) {
    if (!asset.screen && !asset.texel_density) return 0;
    const double wanted = asset.screen ? *asset.screen : *asset.texel_density * *asset.size;
    const int smallest = chain_levels(width, height, 0, true) - 1;
    int level = 0;
    while (level < smallest && level_size(width, level + 1) >= wanted) ++level;
    return level;
}

int choose_level(const SceneAsset& asset, const HeightFacts& facts, BitDepth bits) {
    int level = seen_level(asset, facts.width, facts.height);
    if (asset.max_error || asset.max_shift)
        while (level > 0 && facts.error(bits, level) > height_budget(asset)) --level;
    return level;
}

} // namespace reliefbake

#pragma once
// max_wrong: which sectors and resolution keep the share of wrong rays within it, by marching them (cli/tradeoff).

#include "cli/cone/stored_height.h"
#include "cli/scene/scene_plan.h"

namespace reliefbake {

struct MeasuredChoice {
    int level = 0, sectors = 4;
    double wrong = 0; ///< share of rays that end more than 1/256 of the depth beyond the first hit or before it
};

/// Of the levels from `chosen.level` to 0 and, with technique sectors and no `sectors`, of 4 and 8, the choice of the fewest bytes that
/// keeps max_wrong in `steps` steps at `angle`. Same choice for any number of threads. Errors (budget): none does, with the best found; usage: no renderer.
Result<MeasuredChoice> measure_choices(const SceneAsset& asset, const AssetFacts& chosen, const BakeSource& source, int threads, const std::string& place);

} // namespace reliefbake

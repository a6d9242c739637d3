#pragma once
// Looks at every source of a scene: whether it can be baked at all, and what its assets' budgets ask of it.

#include "cli/scene/scene_plan.h"

namespace reliefbake {

/// Facts of every asset, in order. Decodes every image, checks every height, fits every mesh's quadrics in memory and measures
/// (cli/tradeoff) what max_wrong wants measured: no source that can be refused is left for the bake. Writes nothing. The same
/// for any number of threads. `threads`: resolved.
/// Errors: those of the readers; budget (no choice meets an asset's budget); usage (no renderer, keys that do not suit the source).
Result<std::vector<AssetFacts>> survey_scene(const Scene& scene, int threads);

} // namespace reliefbake

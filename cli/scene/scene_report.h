#pragma once
// What `reliefbake scene` tells.

#include "cli/scene/scene_plan.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// A scene, its plan, and what came of it.
struct SceneRun {
    const Scene& scene;
    const std::vector<AssetFacts>& facts;
    const ScenePlan& plan;
    const ScenePlan& everything;
    std::string folder;
    std::optional<std::vector<double>> seconds; ///< of each job; none: nothing was baked (--dry-run)
};

/// cli/schema/scene.schema.json.
nlohmann::json scene_json(const SceneRun& run);

/// A few lines for a person.
std::string scene_summary(const SceneRun& run);

} // namespace reliefbake

#pragma once
// Assets and facts made by hand.

#include "cli/scene/scene_plan.h"

namespace reliefbake::test {

inline SceneAsset asset(const std::string& name, SceneTechnique technique, const std::string& source = "stone.png") {
    SceneAsset made;
    made.name = name, made.technique = technique;
    (is_of_shape(technique) ? made.shape : made.height) = source;
    if (technique == SceneTechnique::curved) made.mesh = "pot.obj";
    if (technique == SceneTechnique::sectors) made.sectors = 4;
    return made;
}

/// As survey_scene would find them: 256 x 128 texels.
inline std::vector<AssetFacts> facts_of(const Scene& scene) {
    std::vector<AssetFacts> facts(scene.assets.size());
    for (AssetFacts& one : facts) one.width = 256, one.height = 128, one.mesh_bytes = 10000, one.mesh_vertices = 100;
    return facts;
}

inline ScenePlan plan_of(const Scene& scene, const std::vector<AssetFacts>& facts) {
    Result<ScenePlan> plan = plan_scene(scene, facts);
    return plan ? std::move(*plan) : ScenePlan();
}
inline ScenePlan plan_of(const Scene& scene) { return plan_of(scene, facts_of(scene)); }

inline std::vector<SceneMap> maps_of(const ScenePlan& plan) {
    std::vector<SceneMap> maps;
    for (const SceneJob& job : plan.jobs) maps.insert(maps.end(), job.maps.begin(), job.maps.end());
    return maps;
}

} // namespace reliefbake::test

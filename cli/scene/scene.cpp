#include "cli/scene/scene.h"

#include "bake/relief_map.h"

#include <algorithm>
#include <array>
#include <utility>

namespace reliefbake {
namespace {

constexpr std::array<std::pair<const char*, SceneTechnique>, 9> techniques = {{{"cone", SceneTechnique::cone},
                                                                              {"relaxed", SceneTechnique::relaxed},
                                                                              {"sectors", SceneTechnique::sectors},
                                                                              {"cone-normal", SceneTechnique::cone_normal},
                                                                              {"parallax", SceneTechnique::parallax},
                                                                              {"bump", SceneTechnique::bump},
                                                                              {"curved", SceneTechnique::curved},
                                                                              {"extrusion", SceneTechnique::extrusion},
                                                                              {"revolution", SceneTechnique::revolution}}};

} // namespace

bool is_of_shape(SceneTechnique technique) { return technique == SceneTechnique::extrusion || technique == SceneTechnique::revolution; }

bool draws_relief(SceneTechnique technique) { return technique != SceneTechnique::none && technique != SceneTechnique::bump && !is_of_shape(technique); }

bool needs_relief_map(const SceneAsset& asset) { return draws_relief(asset.technique) && !asset.height.empty(); }

bool needs_ambient(const SceneAsset& asset) {
    return asset.features.ao && (asset.technique == SceneTechnique::none || asset.technique == SceneTechnique::bump || asset.technique == SceneTechnique::relaxed);
}

bool needs_normal_map(const SceneAsset& asset) { return asset.technique == SceneTechnique::bump; }

bool needs_horizons(const SceneAsset& asset) {
    return asset.features.shadow && (asset.technique == SceneTechnique::none || asset.technique == SceneTechnique::bump);
}

bool needs_shape_map(const SceneAsset& asset) { return is_of_shape(asset.technique); }

bool needs_quadrics(const SceneAsset& asset) { return asset.features.silhouette && !asset.mesh.empty(); }

bool needs_nothing(const SceneAsset& asset) {
    const auto wanted = {needs_relief_map, needs_ambient, needs_normal_map, needs_horizons, needs_shape_map, needs_quadrics};
    return !asset.is_placed || std::none_of(wanted.begin(), wanted.end(), [&](auto needs) { return needs(asset); });
}

double depth_scale_of(const SceneAsset& asset) {
    if (asset.depth && asset.size) return *asset.depth / *asset.size;
    return asset.depth_uv.value_or(ReliefMapInfo().depth_scale);
}

const char* word_of(SceneTechnique technique) {
    for (const auto& [word, meaning] : techniques)
        if (meaning == technique) return word;
    return "none";
}

std::optional<SceneTechnique> scene_technique_of(const std::string& word) {
    for (const auto& [name, meaning] : techniques)
        if (word == name) return meaning;
    return {};
}

std::string scene_technique_words() {
    std::string words;
    for (const auto& [word, meaning] : techniques) words += (words.empty() ? "" : "|") + std::string(word);
    return words;
}

} // namespace reliefbake

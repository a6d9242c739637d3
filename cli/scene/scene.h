#pragma once
// What a scene asks for: assets, how each is drawn, how near it is seen, how wrong it may be (docs/SCENE.md).

#include "bake/error.h"

#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// How an asset is drawn; `none`: its features alone say what it needs.
enum class SceneTechnique { none, cone, relaxed, sectors, cone_normal, parallax, bump, curved, extrusion, revolution };

/// What a program does with an asset beside drawing it.
struct SceneFeatures {
    bool shadow = false;     ///< of the relief on itself
    bool ao = false;         ///< ambient occlusion, from cones
    bool silhouette = false; ///< rays that leave a curved mesh are discarded: needs its quadrics
    bool mips = false;       ///< a chain of levels
    bool depth = false;      ///< the hit's own depth goes to the depth buffer
};

struct SceneAsset {
    std::string name;
    std::string height, shape, mesh, alpha; ///< paths; empty: none. `alpha`: holes of the height, a file of its size
    SceneTechnique technique = SceneTechnique::none;
    SceneFeatures features;
    bool is_placed = true; ///< false: a material that no primitive of its glTF wears

    // How the source is read: words of the same options of the bakes; empty: their default.
    std::string channel, input, wrap, range;
    bool invert = false, antialiased = false; ///< of shapes

    // Proportions: depth of the relief, in texture widths, or in metres of a texture `size` metres wide.
    std::optional<double> depth_uv, size, depth;

    // How near it is seen: pixels that the texture's width covers at most, or texels that a metre needs.
    std::optional<double> screen, texel_density;
    std::optional<double> angle; ///< steepest, degrees from the normal
    bool trilinear = false;      ///< mips are blended
    std::optional<int> sectors;  ///< 4 or 8

    // How wrong it may be.
    std::optional<double> max_error; ///< height, as a part of the relief's depth, that the stored surface may be off at a texel of the source
    std::optional<double> max_shift; ///< the same in pixels of the screen, seen from `angle`
    std::optional<double> max_wrong; ///< share of rays that end too early or too late within `steps` steps
    std::optional<int> steps;
};

struct Scene {
    std::string file;
    std::string extension = ".png";       ///< of the maps: .png or .tif
    std::vector<SceneAsset> assets;       ///< in the file's order, names unique
    std::vector<std::string> other_files; ///< read or named by the scene and baked by nobody; no output may replace them
};

bool is_of_shape(SceneTechnique technique); ///< extrusion, revolution
bool draws_relief(SceneTechnique technique); ///< marches or shifts over a depth map of its own

// What the maps of an asset are.
bool needs_relief_map(const SceneAsset& asset); ///< its technique's map: cones or depth with normals
bool needs_ambient(const SceneAsset& asset);    ///< conservative cones for ao that its technique's map cannot hold
bool needs_normal_map(const SceneAsset& asset);
bool needs_horizons(const SceneAsset& asset);
bool needs_shape_map(const SceneAsset& asset);
bool needs_quadrics(const SceneAsset& asset);
bool needs_nothing(const SceneAsset& asset);

/// Depth of the relief in texture widths; 0.1 where the asset does not say.
double depth_scale_of(const SceneAsset& asset);

/// "cone-normal", as scene files write it.
const char* word_of(SceneTechnique technique);
std::optional<SceneTechnique> scene_technique_of(const std::string& word);
std::string scene_technique_words(); ///< "cone|relaxed|...", for messages

} // namespace reliefbake

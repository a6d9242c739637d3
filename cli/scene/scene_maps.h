#pragma once
// Each kind of map as a command's options and the files that it writes.

#include "cli/scene/scene_plan.h"

namespace reliefbake {

/// A source, and where its maps go.
struct MapPlace {
    std::string name;      ///< of the files, without suffix and extension
    std::string extension; ///< .png or .tif
    int width, height;     ///< of the source
};

/// The maps of a need, all of one run: one, or with sectors the relief beside it, too.
std::vector<SceneMap> relief_maps(const MapNeed& need, const MapPlace& place);

/// Normals, or horizons of the sky. `depth_scale`: in texture widths; the source option of a bump run.
SceneMap normal_map(BitDepth bits, const MapPlace& place);
SceneMap horizon_map(BitDepth bits, const MapPlace& place);
SceneMap shape_map(const MapPlace& place);
SceneMap quadric_mesh(const std::string& name, std::uint64_t bytes, std::uint64_t vertices);

/// Options that say how a source is read, one word each (--flag=value): those of an asset's keys.
std::vector<std::string> source_options(const SceneAsset& asset);

} // namespace reliefbake

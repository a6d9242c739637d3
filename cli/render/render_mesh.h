#pragma once
// reliefbake render MAP --mesh MESH -o PNG

#include "cli/options/mesh_options.h"
#include "cli/options/solid_options.h"
#include "formats/map_file.h"

#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

struct RenderMeshOptions {
    std::vector<std::string> files; ///< of the meshes; empty: a plane
    MeshOptions mesh;
    bool y_up = false; ///< the meshes' y axis points up, not z
};

/// Adds --mesh, --up and what add_mesh_options adds.
void add_render_mesh_options(CLI::App& app, RenderMeshOptions& options);

/// What the command line says beside them.
struct MeshPicture {
    std::string file; ///< of the map
    const MapHints& hints;
    std::string output;
    const RenderOptions& picture; ///< view, light, size
    const TechniqueOptions& technique;
    const SolidOptions& solid;    ///< depth scale; of shape maps e, b and c
    RendererBackend backend;
};

/// Draws a relief or a shape map (`shape`) over the meshes.
Result<void> render_on_meshes(const MeshPicture& given, const RenderMeshOptions& options, bool shape);

} // namespace reliefbake

#pragma once
// How a map lies on a mesh and its rays are followed there: shared by `render` and `verify`.

#include "cli/command.h"
#include "cli/options/solid_options.h"
#include "cli/options/technique_options.h"
#include "formats/map_file.h"
#include "shaders-reference/renderer/mesh_renderer.h"

#include <string>
#include <utility>

namespace reliefbake {

/// As given.
struct MeshOptions {
    std::pair<double, double> tiles{1, 1};
    Correction correction = Correction::bent;
    bool twist = true;
    std::string ends; ///< "", "u", "v", "uv"

    bool ends_u() const { return ends.find('u') != std::string::npos; }
    bool ends_v() const { return ends.find('v') != std::string::npos; }
};

/// The option group of all that a mesh alone takes.
constexpr const char* mesh_group = "Mesh (curved relief)";

/// Adds --mesh-tiles, --correction, --terms, --ends.
void add_mesh_options(CLI::App& app, MeshOptions& options);

/// A file's one mesh, as curved relief needs it. Errors: those of read_mesh; (usage) several meshes; no texture coordinates; no frames or,
/// but for Correction::none, no quadrics: says how to bake them.
Result<Mesh> read_framed_mesh(const std::string& file, Correction correction);

/// The mesh outlives the result.
MeshObject mesh_object(const Mesh& mesh, const MeshOptions& options, double depth_scale);

/// A relief or a shape map in the renderer, and how its rays are followed; size, camera and light are left as they are.
struct LoadedMap {
    DepthMap relief; ///< what is drawn, as the oracle takes it
    MeshRenderOptions picture;
};

/// Reads `file` and loads it into the renderer, if there is one. `shape`: it is a shape map, of which `solid` makes an extrusion. Errors: those of
/// the file; (usage) no depth; techniques for planes alone; a solid that is none.
Result<LoadedMap> load_mesh_map(MeshRenderer* renderer, const std::string& file, const MapHints& hints, bool shape, const MeshOptions& options,
                                const TechniqueOptions& technique, const SolidOptions& solid);

} // namespace reliefbake

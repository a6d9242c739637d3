#pragma once
// How a map lies on a mesh and its rays are followed there: shared by `render` and `verify`.

#include "cli/command.h"
#include "cli/technique_options.h"
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

/// What a march over meshes takes from the options; size, camera and light are left as they are. Refuses (usage) techniques for planes alone.
Result<MeshRenderOptions> mesh_picture(const MeshOptions& options, const TechniqueOptions& technique, const ReliefMap& map);

} // namespace reliefbake

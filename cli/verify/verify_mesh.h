#pragma once
// reliefbake verify MAP --mesh MESH

#include "cli/options/mesh_options.h"
#include "formats/map_file.h"
#include "shaders-reference/measure/verify_mesh.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reliefbake {

/// As given; unset: by default.
struct VerifyMeshOptions {
    std::string file; ///< of the mesh
    MeshOptions mesh;
    std::optional<BendModel> ideal;
    std::pair<int, int> size{1024, 768};
    std::vector<View> views;
    std::optional<double> least_iou, least_band;
};

/// Adds --mesh, what add_mesh_options adds, --ideal, --mesh-view, --size, --least-iou, --least-band.
void add_verify_mesh_options(CLI::App& app, VerifyMeshOptions& options);

/// Judges the map on the mesh and prints the report. `depth_scale` unset: a tenth of the mesh's radius. `pictures`: a folder that is there, or empty.
struct MeshJudgement {
    std::string file; ///< of the map
    MapHints hints;
    VerifyMeshOptions mesh;
    TechniqueOptions technique;
    SolidOptions solid; ///< depth scale; of shape maps e, b and c
    bool shape; ///< a shape map, whose extrusion is judged
    RendererBackend backend;
    int threads;
    bool json;
    std::string pictures;
};
Result<void> verify_on_mesh(const MeshJudgement& given);

} // namespace reliefbake

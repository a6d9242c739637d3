#pragma once
// reliefbake verify MAP --mesh MESH

#include "cli/command.h"
#include "cli/technique_options.h"
#include "formats/map_file.h"
#include "shaders-reference/measure/verify_mesh.h"
#include "shaders-reference/renderer/mesh_renderer.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reliefbake {

/// As given; unset: by default.
struct VerifyMeshOptions {
    std::string mesh;
    std::pair<double, double> tiles{1, 1};
    Correction correction = Correction::bent;
    bool twist = true;
    std::optional<BendModel> ideal;
    std::string ends;
    std::pair<int, int> size{1024, 768};
    std::vector<View> views;
    std::optional<double> least_iou, least_band;
};

/// The option group of all that a mesh alone takes, and its options: --mesh, --mesh-tiles, --correction, --terms, --ideal, --ends, --mesh-view, --size,
///  --least-iou, --least-band.
constexpr const char* mesh_group = "Mesh (curved relief)";
void add_mesh_options(CLI::App& app, VerifyMeshOptions& options);

/// Judges the map on the mesh and prints the report. `depth_scale` unset: a tenth of the mesh's radius. `pictures`: a folder that is there, or empty.
struct MeshJudgement {
    std::string file; ///< of the map
    MapHints hints;
    VerifyMeshOptions mesh;
    TechniqueOptions technique;
    std::optional<double> depth_scale;
    RendererBackend backend;
    int threads;
    bool json;
    std::string pictures;
};
Result<void> verify_on_mesh(const MeshJudgement& given);

} // namespace reliefbake

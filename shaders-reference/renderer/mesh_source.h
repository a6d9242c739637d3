#pragma once
// The shader texts that draw a map over a curved mesh.

#include "shaders-reference/renderer/shader_source.h"

#include <string>

namespace reliefbake {

constexpr int published_path = 3; ///< CURVED_PATH of the papers' text as printed

/// Everything that is fixed when a program is compiled.
struct MeshConfig {
    bool solid = false;        ///< a shape map's extrusion, not relief
    bool shape_unorm = true, shape_signed = false; ///< of a shape map
    ShaderConfig decoder;      ///< of a relief map
    int path = 2;              ///< CURVED_PATH
    bool sunk_cone = false;    ///< CURVED_CONE
    bool halves = false;       ///< CURVED_HALVES
    bool search = false;       ///< linear search instead of cones
    bool twist = true;
    bool keep = true;          ///< MESH_KEEP

    friend bool operator==(const MeshConfig&, const MeshConfig&) = default;
};

std::string mesh_vertex_source(Prelude prelude);
std::string mesh_fragment_source(const MeshConfig& config, Prelude prelude);

} // namespace reliefbake

#pragma once
// A glTF document as it was read, and which of its primitives make which mesh.

#include "formats/mesh_file.h"

#include <nlohmann/json.hpp>

namespace reliefbake {

/// A primitive's share of a mesh: its vertices and triangles lie together.
struct GltfPrimitive {
    std::size_t mesh = 0, primitive = 0; ///< in the document
    std::uint32_t first_vertex = 0, vertex_count = 0;
    std::uint32_t first_triangle = 0, triangle_count = 0;
};

struct GltfSource {
    nlohmann::ordered_json document;  ///< members in the file's order
    std::vector<std::string> buffers; ///< their bytes, wherever they were
    std::filesystem::path folder;     ///< relative names of images start there
    std::vector<std::vector<GltfPrimitive>> meshes; ///< for each of MeshFile::meshes
};

} // namespace reliefbake

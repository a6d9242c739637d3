#pragma once
// One reader a format: bytes to a mesh. Each refuses (bad_data) with one line that begins with `name`, the file.

#include "formats/mesh_file.h"

#include <string_view>

namespace reliefbake {

/// What a reader may use: bytes of vertices, triangles and buffers together.
struct MeshBudget {
    std::uint64_t bytes;
};

Result<MeshFile> parse_obj(std::string_view text, const MeshBudget& budget, const std::string& name);
Result<MeshFile> parse_ply(std::string_view bytes, const MeshBudget& budget, const std::string& name);
Result<MeshFile> parse_off(std::string_view text, const MeshBudget& budget, const std::string& name);
Result<MeshFile> parse_stl(std::string_view bytes, const MeshBudget& budget, const std::string& name);
/// `folder`: where buffers are looked for, and nowhere above it.
Result<MeshFile> parse_gltf(std::string_view bytes, const std::filesystem::path& folder, const MeshBudget& budget, const std::string& name);

/// Bytes that `vertices` and `triangles` take in memory, attributes and the bake's own tables included.
inline std::uint64_t mesh_bytes(std::uint64_t vertices, std::uint64_t triangles) { return 64 * vertices + 12 * triangles; }

/// Refuses what is over the budget, before it is allocated.
Result<void> check_budget(std::uint64_t vertices, std::uint64_t triangles, const MeshBudget& budget, const std::string& name);

} // namespace reliefbake

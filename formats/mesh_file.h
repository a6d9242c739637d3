#pragma once
// Meshes as files: OBJ, PLY, OFF, STL, glTF and GLB in; PLY, glTF and GLB out. docs/FORMATS.md says what is kept.

#include "bake/error.h"
#include "mesh/mesh.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace reliefbake {

enum class MeshFormat { obj, ply, off, stl, gltf, glb };

/// A glTF file as it was, to be written again with more attributes.
struct GltfSource;

struct MeshFile {
    MeshFormat format;
    std::vector<Mesh> meshes; ///< glTF: for each of its meshes the triangles of all its primitives; else one
    std::vector<std::string> notes; ///< what the file holds and this reader left; one line each
    std::shared_ptr<const GltfSource> gltf; ///< of glTF and GLB alone
};

struct MeshReadOptions {
    /// Budget in bytes for the file and what is decoded; 0: 1 GiB, and 1000 x the file's size above 64 MiB (--max-bytes)
    std::uint64_t max_bytes = 0;
};

/// Nothing in the file can crash or hang the caller. Polygons are cut into triangles; every index is checked; numbers may
/// be NaN or infinite. The format is told by the first bytes, OBJ by its name. glTF buffers are read only from inside the
/// file's own folder. Errors: no_input; bad_data (damaged, nothing to bake: no triangles, over the budget), one line each.
Result<MeshFile> read_mesh(const std::filesystem::path& path, const MeshReadOptions& options = {});

/// The files beside a .gltf or .glb that hold its buffers; none for other files, and where it makes no sense.
std::vector<std::filesystem::path> mesh_buffer_files(const std::filesystem::path& path);

/// How quadrics are stored.
struct QuadricStore {
    enum class Where {
        attribute, ///< glTF _QUADRIC, PLY quadric_a, quadric_b, quadric_c
        uv,        ///< glTF TEXCOORD_n (a, b), and TEXCOORD_n+1 (c, 0) with three terms
        color,     ///< glTF COLOR_0 and PLY red, green, blue: codes about a zero at the middle; `quadric_range` scales them
    } where = Where::attribute;
    int uv_set = 1;
    bool twist = true; ///< c too
};

/// `meshes` go with those of `file` (the same number); `sources[m]` names for each vertex of mesh m the vertex of the input
/// that it copies. `info` becomes the metadata. PLY holds one mesh; glTF keeps everything else of a glTF input as it was. Atomic.
/// Errors: usage (OBJ and others cannot carry quadrics, a store that does not fit); cannot_create, write_failed.
Result<void> write_mesh(const std::filesystem::path& path, const MeshFile& file, const std::vector<Mesh>& meshes,
                        const std::vector<std::vector<std::uint32_t>>& sources, const QuadricStore& store, const nlohmann::json& info);

/// Refuses (usage) a name or store that write_mesh would refuse, before any work.
Result<void> check_mesh_output(const std::filesystem::path& path, const QuadricStore& store);

} // namespace reliefbake

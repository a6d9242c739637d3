#pragma once
// One writer a format: bytes of a whole file.

#include "formats/mesh/gltf_source.h"

#include <cstddef>
#include <span>
#include <vector>

namespace reliefbake {

/// A binary little-endian PLY: x, y, z (double where floats would move a vertex), nx, ny, nz, s, t, tx, ty, tz, tw and the
/// quadric; the metadata as a comment.
std::vector<std::byte> encode_ply(const Mesh& mesh, const QuadricStore& store, const nlohmann::json& info);

/// Largest |a|, |b|, |c|: what the codes of QuadricStore::color run to. 0 where all are 0.
float quadric_range(std::span<const Mesh> meshes, bool twist);
/// Code of `value` in -range..range: the middle code is 0. `codes`: the largest code, 255 or 65535.
std::uint32_t quadric_code(float value, float range, std::uint32_t codes);

/// A glTF document in memory.
struct GltfDocument {
    nlohmann::ordered_json json;
    std::vector<std::string> buffers;
};

/// A document with one mesh that holds positions (as floats), texture coordinates and triangles, and how it is made of them.
/// Errors: bad_data (numbers that are not finite as floats, which glTF cannot hold).
Result<GltfSource> make_gltf(const Mesh& mesh, const std::string& generator, const std::string& name);

/// `source` with normals, tangents and quadrics in the primitives of `meshes`. What these share with the source stays
/// untouched; a primitive with split vertices gets new arrays, copied byte for byte. Everything new lies in one more buffer.
/// Errors: usage (the store does not fit what the file has).
Result<GltfDocument> attach_quadrics(const GltfSource& source, std::span<const Mesh> meshes, std::span<const std::vector<std::uint32_t>> sources,
                                     const QuadricStore& store, const nlohmann::json& info, const std::string& name);

/// All buffers in one BIN chunk. Errors: usage (4 GiB or more).
Result<std::vector<std::byte>> encode_glb(GltfDocument document, const std::string& name);
/// The last buffer as a data URI, buffers without a name too; the others stay where they are.
std::vector<std::byte> encode_gltf(GltfDocument document);

} // namespace reliefbake

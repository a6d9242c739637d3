#include "formats/mesh_file.h"

#include "formats/image_gate.h"
#include "formats/mesh/readers.h"
#include "formats/whole_file.h"

#include <algorithm>
#include <limits>

namespace reliefbake {

namespace {

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return extension;
}

bool looks_like_off(std::string_view bytes) {
    for (const std::string_view start : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"})
        if (bytes.starts_with(start)) return true;
    return false;
}

bool looks_like_json(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != bytes.npos && bytes[first] == '{';
}

} // namespace

Result<void> check_budget(std::uint64_t vertices, std::uint64_t triangles, const MeshBudget& budget, const std::string& name) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max() / 3; // corners are numbered in 32 bits
    if (vertices <= most && triangles <= most && mesh_bytes(vertices, triangles) <= budget.bytes) return {};
    return fail(ErrorCode::bad_data, name + ": holds " + std::to_string(vertices) + " vertices and " + std::to_string(triangles) +
                                         " triangles or more, over the budget of " + std::to_string(budget.bytes) + " bytes; --max-bytes lifts it");
}

Result<MeshFile> read_mesh(const std::filesystem::path& path, const MeshReadOptions& options) {
    constexpr std::uint64_t boundless = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t longest = options.max_bytes > 0 ? options.max_bytes : boundless;
    const Result<std::string> file = read_whole_file(path, longest);
    if (!file) return tl::unexpected(file.error());
    const std::string_view bytes = *file;
    const std::string name = path.string(), extension = extension_of(path);
    if (bytes.empty()) return fail(ErrorCode::bad_data, name + ": is empty");
    const MeshBudget budget{decode_budget(bytes.size(), options.max_bytes)};

    if (bytes.starts_with("glTF") || looks_like_json(bytes)) return parse_gltf(bytes, path.parent_path(), budget, name);
    if (bytes.starts_with("ply")) return parse_ply(bytes, budget, name);
    if (looks_like_off(bytes)) return parse_off(bytes, budget, name);
    if (extension == ".stl" || (bytes.starts_with("solid") && extension != ".obj")) return parse_stl(bytes, budget, name);
    if (extension == ".obj") return parse_obj(bytes, budget, name);
    return fail(ErrorCode::bad_data, name + ": is none of obj, ply, off, stl, gltf, glb");
}

} // namespace reliefbake

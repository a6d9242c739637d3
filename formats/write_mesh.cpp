#include "formats/atomic_file.h"
#include "formats/mesh/writers.h"

namespace reliefbake {

namespace {

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return extension;
}

Result<std::vector<std::byte>> encode_document(const MeshFile& file, const std::vector<Mesh>& meshes,
                                               const std::vector<std::vector<std::uint32_t>>& sources, const QuadricStore& store,
                                               const nlohmann::json& info, const std::string& name, bool binary) {
    GltfSource made;
    std::vector<std::vector<std::uint32_t>> own_sources = sources;
    if (!file.gltf) {
        Result<GltfSource> document = make_gltf(meshes[0], "reliefbake " RELIEFBAKE_VERSION, name);
        if (!document) return tl::unexpected(document.error());
        made = std::move(*document);
        for (std::size_t v = 0; v < own_sources[0].size(); ++v) own_sources[0][v] = std::uint32_t(v); // copies are vertices like others here
    }
    Result<GltfDocument> document = attach_quadrics(file.gltf ? *file.gltf : made, meshes, own_sources, store, info, name);
    if (!document) return tl::unexpected(document.error());
    return binary ? encode_glb(std::move(*document), name) : encode_gltf(std::move(*document));
}

} // namespace

Result<void> check_mesh_output(const std::filesystem::path& path, const QuadricStore& store) {
    const std::string extension = extension_of(path);
    if (extension == ".obj" || extension == ".off" || extension == ".stl")
        return fail(ErrorCode::usage, path.string() + ": " + extension.substr(1) + " files cannot carry quadrics; write .glb, .gltf or .ply");
    if (extension != ".ply" && extension != ".glb" && extension != ".gltf")
        return fail(ErrorCode::usage, path.string() + ": expected a name that ends in .glb, .gltf or .ply");
    if (extension == ".ply" && store.where == QuadricStore::Where::uv)
        return fail(ErrorCode::usage, path.string() + ": --store uv: PLY has no numbered texture coordinates; use attr, or write .glb");
    return {};
}

Result<void> write_mesh(const std::filesystem::path& path, const MeshFile& file, const std::vector<Mesh>& meshes,
                        const std::vector<std::vector<std::uint32_t>>& sources, const QuadricStore& store, const nlohmann::json& info) {
    if (Result<void> fits = check_mesh_output(path, store); !fits) return fits;
    const std::string name = path.string();
    nlohmann::json facts = info;
    if (store.where == QuadricStore::Where::color) facts["range"] = quadric_range(meshes, store.twist);
    if (extension_of(path) == ".ply") {
        if (meshes.size() != 1)
            return fail(ErrorCode::usage, name + ": PLY holds one mesh and the input has " + std::to_string(meshes.size()) + "; write .glb or .gltf");
        return write_file_atomically(path, encode_ply(meshes[0], store, facts));
    }
    try {
        const Result<std::vector<std::byte>> bytes = encode_document(file, meshes, sources, store, facts, name, extension_of(path) == ".glb");
        if (!bytes) return tl::unexpected(bytes.error());
        return write_file_atomically(path, *bytes);
    } catch (const nlohmann::json::exception&) { // a member of another type than glTF wants, where only the writer looks
        return fail(ErrorCode::bad_data, name + ": the input's JSON is no valid glTF; nothing was written");
    }
}

} // namespace reliefbake

// glTF 2.0 and GLB, with tinygltf: it is shown only what geometry needs, and files only from the asset's own folder.

#include "formats/mesh/gltf_accessor.h"
#include "formats/mesh/gltf_container.h"
#include "formats/mesh/gltf_source.h"
#include "formats/mesh/readers.h"
#include "formats/little_endian.h"
#include "formats/whole_file.h"

#include <algorithm>
#include <cstring>

namespace reliefbake {

namespace {

using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// What tinygltf's callbacks know.
struct Folder {
    fs::path path;
    std::uint64_t most;
};

/// The file inside the folder that a URI names; empty when it is none, or lies elsewhere, by links too.
fs::path inside(const Folder& folder, const std::string& uri) {
    std::error_code error;
    const fs::path home = fs::weakly_canonical(folder.path.empty() ? "." : folder.path, error);
    if (error || fs::path(uri).is_absolute()) return {};
    const fs::path file = fs::weakly_canonical(home / uri, error);
    if (error || !fs::is_regular_file(file, error)) return {};
    const auto [end, rest] = std::mismatch(home.begin(), home.end(), file.begin(), file.end());
    return end == home.end() ? file : fs::path();
}

tinygltf::FsCallbacks callbacks(Folder& folder) {
    return {[](const std::string& name, void* f) { return !inside(*static_cast<Folder*>(f), name).empty(); },
            [](const std::string& name, void*) { return name; },
            [](std::vector<unsigned char>* out, std::string* error, const std::string& name, void* f) {
                Folder& home = *static_cast<Folder*>(f);
                const Result<std::string> bytes = read_whole_file(inside(home, name), home.most);
                if (!bytes) *error = bytes.error().message;
                else out->assign(bytes->begin(), bytes->end()), home.most -= bytes->size();
                return bytes.has_value();
            },
            nullptr, &folder};
}

/// Only what geometry needs: no images, no extensions or extras, which tinygltf would turn into trees of its own.
json geometry_of(const json& document) {
    json reduced = {{"asset", {{"version", "2.0"}}}};
    for (const char* key : {"buffers", "bufferViews", "accessors", "meshes"}) {
        if (!document.contains(key) || !document[key].is_array()) continue;
        reduced[key] = document[key];
        for (json& item : reduced[key])
            for (const char* extra : {"extensions", "extras", "name", "weights"})
                if (item.is_object()) item.erase(extra);
    }
    if (reduced.contains("meshes"))
        for (json& mesh : reduced["meshes"]) {
            if (!mesh.is_object() || !mesh.contains("primitives") || !mesh["primitives"].is_array()) continue;
            for (json& primitive : mesh["primitives"])
                for (const char* extra : {"extensions", "extras", "targets", "material"})
                    if (primitive.is_object()) primitive.erase(extra);
        }
    return reduced;
}

/// Where vertex data is compressed by an extension, there are no arrays to read.
const char* compression_of(const json& document) {
    const auto used = document.find("extensionsRequired");
    if (used == document.end() || !used->is_array()) return nullptr;
    for (const char* extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
        if (std::find(used->begin(), used->end(), extension) != used->end()) return extension;
    return nullptr;
}

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::erase_if(text, [](unsigned char c) { return c < ' ' || c >= 127; });
    while (!text.empty() && text.back() == ' ') text.pop_back();
    constexpr std::size_t longest = 200;
    return text.substr(0, longest);
}

Result<tinygltf::Model> load_geometry(const json& document, const GltfChunks& chunks, const fs::path& folder, const MeshBudget& budget,
                                      const std::string& name) {
    const std::string text = geometry_of(document).dump();
    Folder home{folder, budget.bytes};
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks(callbacks(home));
    tinygltf::Model model;
    std::string error, warning;
    bool ok = false;
    try {
        if (chunks.is_binary) {
            ByteWriter glb;
            const std::string padding((4 - text.size() % 4) % 4, ' ');
            const bool has_binary = chunks.binary.size() >= 4;
            glb.text("glTF"), glb.u32(2);
            glb.u32(std::uint32_t(20 + text.size() + padding.size() + (has_binary ? 8 + chunks.binary.size() : 0)));
            glb.u32(std::uint32_t(text.size() + padding.size())), glb.text("JSON"), glb.text(text), glb.text(padding);
            if (has_binary) glb.u32(std::uint32_t(chunks.binary.size())), glb.u32(0x004e4942), glb.text(chunks.binary);
            const std::vector<std::byte> bytes = glb.take();
            ok = loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                             unsigned(bytes.size()), "", 0);
        } else {
            ok = loader.LoadASCIIFromString(&model, &error, &warning, text.data(), unsigned(text.size()), "", 0);
        }
    } catch (const std::exception& e) {
        error = e.what();
    }
    if (ok) return model;
    return fail(ErrorCode::bad_data, name + ": cannot be decoded: " + (error.empty() ? "tinygltf gives no reason" : one_line(error)));
}

class MeshAssembler {
  public:
    MeshAssembler(const tinygltf::Model& model, const MeshBudget& budget, const std::string& name) : model_(model), budget_(budget), name_(name) {}

    Result<void> add(std::size_t mesh_index, GltfSource& source, std::vector<Mesh>& meshes, std::vector<std::string>& notes) {
        mesh_ = Mesh{};
        mesh_.v_down = true;
        std::vector<GltfPrimitive> shares;
        const tinygltf::Mesh& mesh = model_.meshes[mesh_index];
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
            const int mode = mesh.primitives[p].mode < 0 ? TINYGLTF_MODE_TRIANGLES : mesh.primitives[p].mode;
            if (mode < TINYGLTF_MODE_TRIANGLES || !mesh.primitives[p].attributes.count("POSITION")) {
                notes.push_back("mesh " + std::to_string(mesh_index) + ", primitive " + std::to_string(p) + " holds no triangles and stays as it is");
                continue;
            }
            GltfPrimitive share{mesh_index, p, std::uint32_t(mesh_.positions.size()), 0, std::uint32_t(mesh_.triangles.size()), 0};
            const Result<void> added = add_primitive(mesh.primitives[p], mode, share);
            if (!added) return added;
            shares.push_back(share);
        }
        if (shares.empty()) return {};
        source.meshes.push_back(std::move(shares));
        meshes.push_back(std::move(mesh_));
        return {};
    }

  private:
    Result<GltfArray> array(const tinygltf::Primitive& primitive, const char* semantic, int components, std::size_t count) {
        Result<GltfArray> a = read_accessor(model_, primitive.attributes.at(semantic), budget_, name_);
        if (a && (a->components != components || (count > 0 && a->count != count)))
            return fail(ErrorCode::bad_data, name_ + ": " + semantic + " has " + std::to_string(a->count) + " elements of " + std::to_string(a->components) +
                                                 "; expected " + std::to_string(count ? count : a->count) + " of " + std::to_string(components));
        return a;
    }

    /// Appends one attribute; where other primitives have it and this one does not, zeros.
    template <class Vector>
    Result<void> append(const tinygltf::Primitive& primitive, const char* semantic, std::size_t count, std::vector<Vector>& out) {
        const std::size_t before = mesh_.positions.size() - count;
        if (!primitive.attributes.count(semantic)) {
            if (!out.empty()) out.resize(before + count, Vector(0));
            return {};
        }
        const Result<GltfArray> a = array(primitive, semantic, int(Vector::dimensions()), count);
        if (!a) return tl::unexpected(a.error());
        out.resize(before, Vector(0));
        for (std::size_t k = 0; k < count; ++k) {
            Vector value;
            for (int c = 0; c < int(Vector::dimensions()); ++c) value[c] = typename Vector::BaseType(a->number(k, c));
            out.push_back(value);
        }
        return {};
    }

    Result<void> append_quadrics(const tinygltf::Primitive& primitive, std::size_t count) {
        const auto found = primitive.attributes.find("_QUADRIC");
        if (found == primitive.attributes.end()) {
            if (!mesh_.quadrics.empty()) mesh_.quadrics.resize(mesh_.positions.size());
            return {};
        }
        const Result<GltfArray> a = read_accessor(model_, found->second, budget_, name_);
        if (!a) return tl::unexpected(a.error());
        if (a->count != count || a->components < 2 || a->components > 3)
            return fail(ErrorCode::bad_data, name_ + ": _QUADRIC has " + std::to_string(a->count) + " elements of " + std::to_string(a->components) +
                                                 "; expected " + std::to_string(count) + " of 2 or 3");
        mesh_.quadrics.resize(mesh_.positions.size() - count);
        for (std::size_t k = 0; k < count; ++k)
            mesh_.quadrics.push_back({float(a->number(k, 0)), float(a->number(k, 1)), a->components == 3 ? float(a->number(k, 2)) : 0});
        return {};
    }

    Result<std::vector<std::uint32_t>> indices(const tinygltf::Primitive& primitive, std::size_t count) {
        std::vector<std::uint32_t> list;
        if (primitive.indices < 0) {
            for (std::size_t k = 0; k < count; ++k) list.push_back(std::uint32_t(k));
            return list;
        }
        const Result<GltfArray> a = read_accessor(model_, primitive.indices, budget_, name_);
        if (!a) return tl::unexpected(a.error());
        if (a->components != 1 || a->component_type == TINYGLTF_COMPONENT_TYPE_FLOAT)
            return fail(ErrorCode::bad_data, name_ + ": indices are no whole numbers");
        for (std::size_t k = 0; k < a->count; ++k) {
            const double index = a->number(k, 0);
            if (!(index >= 0 && index < double(count)))
                return fail(ErrorCode::bad_data, name_ + ": a triangle names vertex " + std::to_string(std::int64_t(index)) + " of " + std::to_string(count));
            list.push_back(std::uint32_t(index));
        }
        return list;
    }

    Result<void> add_primitive(const tinygltf::Primitive& primitive, int mode, GltfPrimitive& share) {
        const Result<GltfArray> positions = array(primitive, "POSITION", 3, 0);
        if (!positions) return tl::unexpected(positions.error());
        const std::size_t count = positions->count;
        const Result<std::vector<std::uint32_t>> list = indices(primitive, count);
        if (!list) return tl::unexpected(list.error());
        const std::size_t triangles = mode == TINYGLTF_MODE_TRIANGLES ? list->size() / 3 : list->size() < 3 ? 0 : list->size() - 2;
        if (Result<void> fits = check_budget(mesh_.positions.size() + count, mesh_.triangles.size() + triangles, budget_, name_); !fits) return fits;

        for (std::size_t k = 0; k < count; ++k) mesh_.positions.push_back({positions->number(k, 0), positions->number(k, 1), positions->number(k, 2)});
        for (std::size_t t = 0; t < triangles; ++t) {
            const std::size_t k = mode == TINYGLTF_MODE_TRIANGLES ? 3 * t : t;
            const std::size_t first = mode == TINYGLTF_MODE_TRIANGLE_FAN ? 0 : k;
            const bool turned = mode == TINYGLTF_MODE_TRIANGLE_STRIP && t % 2 == 1;
            const std::uint32_t a = (*list)[first], b = (*list)[turned ? k + 2 : k + 1], c = (*list)[turned ? k + 1 : k + 2];
            mesh_.triangles.push_back({share.first_vertex + a, share.first_vertex + b, share.first_vertex + c});
        }
        share.vertex_count = std::uint32_t(count), share.triangle_count = std::uint32_t(triangles);
        return append(primitive, "NORMAL", count, mesh_.normals)
            .and_then([&] { return append(primitive, "TEXCOORD_0", count, mesh_.uvs); })
            .and_then([&] { return append(primitive, "TANGENT", count, mesh_.tangents); })
            .and_then([&] { return append_quadrics(primitive, count); });
    }

    const tinygltf::Model& model_;
    const MeshBudget& budget_;
    const std::string& name_;
    Mesh mesh_;
};

} // namespace

Result<MeshFile> parse_gltf(std::string_view bytes, const fs::path& folder, const MeshBudget& budget, const std::string& name) {
    const Result<GltfChunks> chunks = split_gltf(bytes, name);
    if (!chunks) return tl::unexpected(chunks.error());
    if (Result<void> small = check_json_size(chunks->json, budget.bytes, name); !small) return tl::unexpected(small.error());
    auto source = std::make_shared<GltfSource>();
    source->document = json::parse(chunks->json, nullptr, false);
    if (!source->document.is_object()) return fail(ErrorCode::bad_data, name + ": its JSON is damaged");
    if (const char* extension = compression_of(source->document))
        return fail(ErrorCode::bad_data, name + ": is compressed with " + extension + ", which is not read; decompress it first");

    Result<tinygltf::Model> model = load_geometry(source->document, *chunks, folder, budget, name);
    if (!model) return tl::unexpected(model.error());
    MeshFile file{chunks->is_binary ? MeshFormat::glb : MeshFormat::gltf, {}, {}, {}};
    MeshAssembler assembler(*model, budget, name);
    for (std::size_t m = 0; m < model->meshes.size(); ++m)
        if (Result<void> added = assembler.add(m, *source, file.meshes, file.notes); !added) return tl::unexpected(added.error());
    if (std::all_of(file.meshes.begin(), file.meshes.end(), [](const Mesh& m) { return m.triangles.empty(); }))
        return fail(ErrorCode::bad_data, name + ": has no triangles to bake");
    for (const tinygltf::Buffer& buffer : model->buffers) source->buffers.emplace_back(buffer.data.begin(), buffer.data.end());
    source->folder = folder;
    file.gltf = std::move(source);
    return file;
}

} // namespace reliefbake

#include "cli/scene/read_scene.h"
#include "cli/scene/scene_keys.h"
#include "formats/mesh/gltf_container.h"
#include "formats/whole_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

namespace reliefbake {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uint64_t most_bytes = 1u << 30;

int hex_digit(char c) { return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1; }

/// %20 and the like; nothing where a '%' is none.
std::optional<std::string> decoded_uri(const std::string& uri) {
    std::string path;
    for (std::size_t k = 0; k < uri.size(); ++k) {
        if (uri[k] != '%') {
            path += uri[k];
            continue;
        }
        const int high = k + 2 < uri.size() ? hex_digit(uri[k + 1]) : -1, low = high >= 0 ? hex_digit(uri[k + 2]) : -1;
        if (low < 0) return {};
        path += char(16 * high + low);
        k += 2;
    }
    return path;
}

/// Inside of the folder of `file`, also behind links.
Result<std::string> resolve_uri(const std::string& file, const std::string& uri) {
    const auto refused = [&](const std::string& words) { return fail(ErrorCode::usage, "'" + uri + "': " + words); };
    const std::optional<std::string> path = decoded_uri(uri);
    if (!path || path->empty() || path->find('\0') != path->npos || path->find('\\') != path->npos) return refused("is no URI of a file");
    if (path->find(':') != path->npos || path->front() == '/') return refused("expected a file beside the glTF, by a relative URI");
    const fs::path parent = fs::path(file).parent_path(), folder = parent.empty() ? "." : parent;
    std::error_code error;
    const fs::path root = fs::weakly_canonical(folder, error), whole = fs::weakly_canonical(folder / *path, error);
    const auto [end_of_root, rest] = std::mismatch(root.begin(), root.end(), whole.begin(), whole.end());
    if (error || end_of_root != root.end() || rest == whole.end()) return refused("leaves the folder of the glTF, which its URIs may not");
    return (folder / *path).lexically_normal().string();
}

SceneValue value_of(const json& value) {
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_number()) return value.get<double>();
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_array()) return std::monostate();
    std::vector<std::string> words;
    for (const json& word : value) {
        if (!word.is_string()) return std::monostate();
        words.push_back(word.get<std::string>());
    }
    return words;
}

/// The array member of an object, or none.
const json& list_of(const json& object, const char* key) {
    static const json none = json::array();
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() && found->is_array() ? *found : none;
}

/// Materials that some primitive wears.
std::set<std::size_t> worn_materials(const json& document) {
    std::set<std::size_t> worn;
    for (const json& mesh : list_of(document, "meshes"))
        for (const json& primitive : list_of(mesh, "primitives"))
            if (primitive.is_object() && primitive.contains("material") && primitive["material"].is_number_unsigned()) worn.insert(primitive["material"].get<std::size_t>());
    return worn;
}

/// Files that buffers and images name.
void add_other_files(const json& document, Scene& scene) {
    for (const char* kind : {"buffers", "images"})
        for (const json& item : list_of(document, kind)) {
            if (!item.is_object() || !item.contains("uri") || !item["uri"].is_string()) continue;
            const std::string uri = item["uri"].get<std::string>();
            if (uri.starts_with("data:")) continue;
            if (const Result<std::string> path = resolve_uri(scene.file, uri)) scene.other_files.push_back(*path); // a bake writes nowhere near any other
        }
}

Result<SceneAsset> asset_of_material(const json& material, std::size_t number, const std::string& file) {
    const json& extras = material["extras"]["reliefbake"];
    const bool has_name = material.contains("name") && material["name"].is_string() && !material["name"].get<std::string>().empty();
    const std::string name = has_name ? material["name"].get<std::string>() : "material " + std::to_string(number);
    if (!extras.is_object()) return fail(ErrorCode::usage, file + ": material " + std::to_string(number) + ": extras.reliefbake: expected an object");
    SceneKeys keys;
    for (const auto& [key, value] : extras.items()) keys[key] = value_of(value);
    if (keys.count("name") > 0) return fail(ErrorCode::usage, file + ": material " + std::to_string(number) + ": name: is the material's; leave it out of extras.reliefbake");
    // A curved relief lies on the file's own meshes, unless it names another.
    const std::string own = fs::path(file).filename().string();
    const auto technique = keys.find("technique");
    if (technique != keys.end() && technique->second == SceneValue(std::string("curved")) && keys.count("mesh") == 0) keys["mesh"] = own;
    const ResolvePath resolve = [&](const std::string& uri) { return uri == own ? Result<std::string>(file) : resolve_uri(file, uri); };
    return asset_of(keys, name, resolve, file);
}

} // namespace

Result<Scene> read_scene_gltf(const std::string& file) {
    const Result<std::string> bytes = read_whole_file(file, most_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    const Result<GltfChunks> chunks = split_gltf(*bytes, file);
    if (!chunks) return tl::unexpected(chunks.error());
    if (Result<void> small = check_json_size(chunks->json, most_bytes, file); !small) return tl::unexpected(small.error());
    const json document = json::parse(chunks->json, nullptr, false);
    if (document.is_discarded() || !document.is_object()) return fail(ErrorCode::bad_data, file + ": is no glTF: its JSON is damaged");

    Scene scene;
    scene.file = file;
    add_other_files(document, scene);
    const std::set<std::size_t> worn = worn_materials(document);
    const json& materials = list_of(document, "materials");
    for (std::size_t k = 0; k < materials.size(); ++k) {
        const json& material = materials[k];
        if (!material.is_object() || !material.contains("extras") || !material["extras"].is_object() || !material["extras"].contains("reliefbake")) continue;
        Result<SceneAsset> asset = asset_of_material(material, k, file);
        if (!asset) return tl::unexpected(asset.error());
        asset->is_placed = worn.count(k) > 0;
        scene.assets.push_back(std::move(*asset));
    }
    return scene;
}

} // namespace reliefbake

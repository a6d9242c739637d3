#include "cli/scene/read_scene.h"
#include "cli/scene/scene_keys.h"
#include "formats/toml_file.h"

#include <filesystem>

namespace reliefbake {
namespace {

namespace fs = std::filesystem;

SceneValue value_of(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* truth = node.as_boolean()) return truth->get();
    if (const auto* whole = node.as_integer()) return double(whole->get());
    if (const auto* number = node.as_floating_point()) return number->get();
    const toml::array* list = node.as_array();
    if (!list) return std::monostate();
    std::vector<std::string> words;
    for (const toml::node& word : *list) {
        if (!word.is_string()) return std::monostate();
        words.push_back(word.as_string()->get());
    }
    return words;
}

Result<std::string> read_extension(const toml::table& table, const std::string& file) {
    const Result<std::optional<std::string>> format = toml_value<std::string>(table, "format", file);
    if (!format) return tl::unexpected(format.error());
    if (!*format || **format == "png") return std::string(".png");
    if (**format == "tif") return std::string(".tif");
    return toml_fault(*table.get("format"), file, "format: expected png or tif, found '" + **format + "'");
}

/// From the folder of the scene.
Result<std::string> resolve_path(const std::string& file, const std::string& path) { return (fs::path(file).parent_path() / path).lexically_normal().string(); }

} // namespace

Result<Scene> read_scene_toml(const std::string& file) {
    const Result<toml::table> table = read_toml_file(file);
    if (!table) return tl::unexpected(table.error());
    if (Result<void> known = refuse_unknown_keys(*table, {"format", "asset"}, file); !known) return tl::unexpected(known.error());
    const Result<std::string> extension = read_extension(*table, file);
    if (!extension) return tl::unexpected(extension.error());
    const Result<const toml::array*> assets = toml_part<toml::array>(*table, "asset", file);
    if (!assets) return tl::unexpected(assets.error());

    Scene scene;
    scene.file = file, scene.extension = *extension;
    const ResolvePath resolve = [&](const std::string& path) { return resolve_path(file, path); };
    for (std::size_t k = 0; *assets && k < (*assets)->size(); ++k) {
        const toml::table* keys = (*assets)->get(k)->as_table();
        if (!keys) return toml_fault(*(*assets)->get(k), file, "asset: expected [[asset]] tables");
        SceneKeys values;
        for (const auto& [key, value] : *keys) values[std::string(key.str())] = value_of(value);
        Result<SceneAsset> asset = asset_of(values, "", resolve, file + (keys->source().begin.line > 0 ? ":" + std::to_string(keys->source().begin.line) : ""));
        if (!asset) return tl::unexpected(asset.error());
        scene.assets.push_back(std::move(*asset));
    }
    return scene;
}

} // namespace reliefbake

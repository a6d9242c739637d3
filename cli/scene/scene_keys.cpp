#include "cli/scene/scene_keys.h"

#include "cli/report/format_text.h"
#include "cli/scene/scene_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {
namespace {

constexpr const char* path_keys[] = {"height", "shape", "mesh", "alpha"};
constexpr const char* known_keys[] = {"name", "height", "shape", "mesh", "alpha", "technique", "features", "channel", "input", "wrap", "range", "invert", "antialiased",
                                      "depth_uv", "size", "depth", "screen", "texel_density", "angle", "mip_filter", "sectors", "max_error", "max_shift", "max_wrong", "steps"};

/// Takes values out of the keys; keeps the first refusal.
class KeyReader {
  public:
    KeyReader(const SceneKeys& keys, std::string place) : keys_(keys), place_(std::move(place)) {}

    template <class T>
    const T* find(const char* key, const char* expected) {
        const auto found = keys_.find(key);
        if (found == keys_.end()) return nullptr;
        const T* value = std::get_if<T>(&found->second);
        if (!value) refuse(std::string(key) + ": expected " + expected);
        return value;
    }
    void read(const char* key, std::string& target) {
        const std::string* text = find<std::string>(key, "text");
        if (!text) return;
        if (text->empty() || text->find('\0') != text->npos) return refuse(std::string(key) + ": expected text, found none");
        target = *text;
    }
    void read(const char* key, bool& target) {
        if (const bool* value = find<bool>(key, "true or false")) target = *value;
    }
    void read(const char* key, std::optional<double>& target) {
        if (const double* value = find<double>(key, "a number")) target = *value;
    }
    void read(const char* key, std::optional<int>& target) {
        const double* value = find<double>(key, "a whole number");
        if (!value) return;
        if (!(std::fabs(*value) <= std::numeric_limits<int>::max()) || *value != std::floor(*value)) return refuse(std::string(key) + ": expected a whole number, found " + digits(*value));
        target = int(*value);
    }
    void refuse(const std::string& words) {
        if (error_.empty()) error_ = place_ + ": " + words;
    }
    Result<void> result() const { return error_.empty() ? Result<void>() : fail(ErrorCode::usage, error_); }

  private:
    const SceneKeys& keys_;
    std::string place_, error_;
};

void read_features(KeyReader& reader, SceneFeatures& features) {
    const std::vector<std::string>* words = reader.find<std::vector<std::string>>("features", "a list of shadow, ao, silhouette, mips, depth");
    if (!words) return;
    for (const std::string& word : *words) {
        bool* feature = word == "shadow" ? &features.shadow : word == "ao" ? &features.ao : word == "silhouette" ? &features.silhouette : word == "mips" ? &features.mips : word == "depth" ? &features.depth : nullptr;
        if (!feature || *feature) return reader.refuse("features: expected each of shadow, ao, silhouette, mips, depth at most once, found '" + word + "'");
        *feature = true;
    }
}

void read_technique(KeyReader& reader, SceneTechnique& target) {
    std::string word;
    reader.read("technique", word);
    if (word.empty()) return;
    const std::optional<SceneTechnique> technique = scene_technique_of(word);
    if (!technique) return reader.refuse("technique: expected " + scene_technique_words() + ", found '" + word + "'");
    target = *technique;
}

void read_mip_filter(KeyReader& reader, bool& trilinear) {
    std::string word;
    reader.read("mip_filter", word);
    if (word.empty()) return;
    if (word != "nearest" && word != "trilinear") return reader.refuse("mip_filter: expected nearest or trilinear, found '" + word + "'");
    trilinear = word == "trilinear";
}

Result<void> resolve_paths(SceneAsset& asset, const ResolvePath& resolve, const std::string& place) {
    for (std::string* path : {&asset.height, &asset.shape, &asset.mesh, &asset.alpha}) {
        if (path->empty()) continue;
        Result<std::string> resolved = resolve(*path);
        if (!resolved) return fail(resolved.error().code, place + ": " + resolved.error().message);
        *path = *resolved;
    }
    return {};
}

} // namespace

Result<SceneAsset> asset_of(const SceneKeys& keys, const std::string& name, const ResolvePath& resolve, const std::string& file) {
    SceneAsset asset;
    asset.name = name;
    KeyReader named(keys, file + ": an asset");
    named.read("name", asset.name);
    if (Result<void> read = named.result(); !read) return tl::unexpected(read.error());
    if (Result<void> fits = check_asset_name(asset.name, file + ": an asset"); !fits) return tl::unexpected(fits.error());

    const std::string place = file + ": asset '" + asset.name + "'";
    std::set<std::string> given;
    for (const auto& [key, value] : keys) {
        if (std::find_if(std::begin(known_keys), std::end(known_keys), [&, &wanted = key](const char* known) { return wanted == known; }) == std::end(known_keys))
            return fail(ErrorCode::usage, place + ": unknown key '" + key + "' (docs/SCENE.md lists them)");
        given.insert(key);
    }
    KeyReader reader(keys, place);
    std::string* paths[] = {&asset.height, &asset.shape, &asset.mesh, &asset.alpha};
    for (std::size_t k = 0; k < std::size(path_keys); ++k) reader.read(path_keys[k], *paths[k]);
    read_technique(reader, asset.technique);
    read_features(reader, asset.features);
    read_mip_filter(reader, asset.trilinear);
    reader.read("channel", asset.channel), reader.read("input", asset.input), reader.read("wrap", asset.wrap), reader.read("range", asset.range);
    reader.read("invert", asset.invert), reader.read("antialiased", asset.antialiased);
    reader.read("depth_uv", asset.depth_uv), reader.read("size", asset.size), reader.read("depth", asset.depth);
    reader.read("screen", asset.screen), reader.read("texel_density", asset.texel_density), reader.read("angle", asset.angle);
    reader.read("max_error", asset.max_error), reader.read("max_shift", asset.max_shift), reader.read("max_wrong", asset.max_wrong);
    reader.read("sectors", asset.sectors), reader.read("steps", asset.steps);
    return reader.result()
        .and_then([&] { return resolve_paths(asset, resolve, place); })
        .and_then([&] { return check_asset(asset, given, place); })
        .map([&] { return asset; });
}

Result<void> check_names(const Scene& scene) {
    std::map<std::string, std::string> seen;
    for (const SceneAsset& asset : scene.assets) {
        std::string folded = asset.name;
        for (char& c : folded)
            if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
        const auto [known, is_new] = seen.emplace(folded, asset.name);
        if (!is_new) return fail(ErrorCode::usage, scene.file + ": two assets named '" + asset.name + "'" + (known->second == asset.name ? "" : " and '" + known->second + "'") + ": their maps would be one file; rename one");
    }
    return {};
}

} // namespace reliefbake

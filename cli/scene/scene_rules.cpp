#include "cli/scene/scene_rules.h"

#include "cli/report/format_text.h"

#include <cmath>

namespace reliefbake {
namespace {

/// A key, when it has a meaning, and what it wants where it has none.
struct Rule {
    const char* key;
    bool (*holds)(const SceneAsset&);
    const char* wants;
};

bool has_height(const SceneAsset& a) { return !a.height.empty(); }
bool has_shape(const SceneAsset& a) { return !a.shape.empty(); }
bool has_source(const SceneAsset& a) { return has_height(a) || has_shape(a); }
bool bakes_cone_maps(const SceneAsset& a) { return needs_relief_map(a) || needs_ambient(a); }
bool bakes_bump_maps(const SceneAsset& a) { return needs_normal_map(a) || needs_horizons(a); }
bool knows_depth_scale(const SceneAsset& a) { return needs_relief_map(a) || bakes_bump_maps(a); }
bool can_be_blended(const SceneAsset& a) {
    switch (a.technique) {
    case SceneTechnique::cone:
    case SceneTechnique::sectors:
    case SceneTechnique::cone_normal:
    case SceneTechnique::curved: return true;
    case SceneTechnique::relaxed: return false;
    default: return a.features.ao;
    }
}
bool is_measured(const SceneAsset& a) {
    return a.technique == SceneTechnique::cone || a.technique == SceneTechnique::relaxed || a.technique == SceneTechnique::sectors || a.technique == SceneTechnique::cone_normal;
}

/// In the order of messages: what a key is missing first.
constexpr Rule rules[] = {
    {"shape", [](const SceneAsset& a) { return !has_height(a); }, "an asset has a height or a shape"},
    {"shape", [](const SceneAsset& a) { return is_of_shape(a.technique) || a.technique == SceneTechnique::none; }, "technique extrusion or revolution"},
    {"mesh", [](const SceneAsset& a) { return a.technique == SceneTechnique::curved || a.technique == SceneTechnique::extrusion || a.technique == SceneTechnique::none; },
     "technique curved or extrusion, which follow a mesh"},
    {"channel", has_source, "a height or a shape"},
    {"wrap", has_source, "a height or a shape"},
    {"wrap", [](const SceneAsset& a) { return !has_shape(a) || a.wrap.find("auto") == a.wrap.npos; }, "repeat or clamp: shapes know no auto"},
    {"input", has_height, "a height"},
    {"range", has_height, "a height"},
    {"alpha", has_height, "a height"},
    {"alpha", [](const SceneAsset& a) { return !bakes_bump_maps(a); }, "a technique with cones or depth: normal and horizon maps have no holes"},
    {"invert", has_shape, "a shape"},
    {"antialiased", has_shape, "a shape"},
    {"depth_uv", knows_depth_scale, "a map whose normals or horizons depend on how deep the relief is"},
    {"depth_uv", [](const SceneAsset& a) { return !a.depth; }, "no depth beside it"},
    {"depth", knows_depth_scale, "a map whose normals or horizons depend on how deep the relief is"},
    {"depth", [](const SceneAsset& a) { return a.size.has_value(); }, "size beside it"},
    {"size", [](const SceneAsset& a) { return a.depth || a.texel_density; }, "depth or texel_density beside it"},
    {"screen", bakes_cone_maps, "a map that can have fewer texels: a technique over a height (not bump), or ao"},
    {"screen", [](const SceneAsset& a) { return !a.texel_density; }, "no texel_density beside it"},
    {"texel_density", bakes_cone_maps, "a map that can have fewer texels: a technique over a height (not bump), or ao"},
    {"texel_density", [](const SceneAsset& a) { return a.size.has_value(); }, "size beside it"},
    {"mip_filter", [](const SceneAsset& a) { return a.features.mips; }, "the feature mips"},
    {"mip_filter", [](const SceneAsset& a) { return !a.trilinear || can_be_blended(a); }, "cones that stay safe when levels are blended: technique cone, cone-normal, sectors or curved, or ao; not relaxed"},
    {"sectors", [](const SceneAsset& a) { return a.technique == SceneTechnique::sectors; }, "technique sectors"},
    {"max_error", [](const SceneAsset& a) { return bakes_cone_maps(a) || bakes_bump_maps(a); }, "a map of a height"},
    {"max_error", [](const SceneAsset& a) { return !a.max_shift; }, "no max_shift beside it"},
    {"max_shift", needs_relief_map, "a technique that follows a height"},
    {"max_shift", [](const SceneAsset& a) { return a.screen && a.angle; }, "screen and angle beside it"},
    {"max_wrong", is_measured, "technique cone, relaxed, sectors or cone-normal: others are not measured"},
    {"max_wrong", [](const SceneAsset& a) { return a.steps && a.angle; }, "steps and angle beside it"},
    {"steps", [](const SceneAsset& a) { return a.max_wrong.has_value(); }, "max_wrong beside it"},
    {"angle", [](const SceneAsset& a) { return a.max_wrong || a.max_shift; }, "max_wrong or max_shift beside it"}};

Result<void> check_technique(const SceneAsset& a, const std::string& place) {
    const auto refused = [&](const std::string& words) { return fail(ErrorCode::usage, place + ": " + words); };
    const std::string word = word_of(a.technique);
    if (a.height.empty() && a.shape.empty() && a.mesh.empty()) return refused("expected a height, a shape or a mesh");
    if (is_of_shape(a.technique) && !has_shape(a)) return refused("technique " + word + " needs a shape");
    if (a.technique == SceneTechnique::curved && a.mesh.empty()) return refused("technique curved needs a mesh");
    if (a.technique != SceneTechnique::none && a.technique != SceneTechnique::curved && !is_of_shape(a.technique) && !has_height(a))
        return refused("technique " + word + " needs a height");
    if (a.technique == SceneTechnique::sectors && !a.sectors && !a.max_wrong) return refused("technique sectors: expected sectors = 4 or 8, or max_wrong, by which they are chosen");
    return {};
}

Result<void> check_features(const SceneAsset& a, const std::string& place) {
    const auto refused = [&](const std::string& words) { return fail(ErrorCode::usage, place + ": feature " + words); };
    const bool of_shape = is_of_shape(a.technique), relief = needs_relief_map(a);
    if (a.features.shadow && !of_shape && !has_height(a)) return refused("shadow: needs a height, or a technique over a shape");
    if (a.features.ao && !has_height(a)) return refused("ao: needs a height; it is read from cones");
    if (a.features.silhouette && a.mesh.empty()) return refused("silhouette: needs a mesh; a flat polygon's border needs no map");
    if (a.features.mips && !bakes_cone_maps(a)) return refused("mips: needs a map that has levels: a technique over a height (not bump), or ao");
    if (a.features.depth && !relief && !of_shape) return refused("depth: needs a technique that finds one: any but bump");
    return {};
}

Result<void> check_numbers(const SceneAsset& a, const std::string& place) {
    struct Range {
        const char* key;
        const std::optional<double>& value;
        double low, high;
    };
    const Range ranges[] = {{"depth_uv", a.depth_uv, 1e-6, 1e6},      {"size", a.size, 1e-6, 1e6},           {"depth", a.depth, 1e-6, 1e6},
                            {"screen", a.screen, 1, 1e6},             {"texel_density", a.texel_density, 1e-6, 1e9}, {"angle", a.angle, 1, 89.9},
                            {"max_error", a.max_error, 1e-12, 1},     {"max_shift", a.max_shift, 1e-6, 1e6}, {"max_wrong", a.max_wrong, 0, 1}};
    for (const Range& range : ranges)
        if (range.value && !(*range.value >= range.low && *range.value <= range.high))
            return fail(ErrorCode::usage, place + ": " + range.key + ": expected a number from " + digits(range.low) + " to " + digits(range.high) + ", found " + digits(*range.value));
    if (a.sectors && *a.sectors != 4 && *a.sectors != 8) return fail(ErrorCode::usage, place + ": sectors: expected 4 or 8, found " + std::to_string(*a.sectors));
    if (a.steps && (*a.steps < 1 || *a.steps > 100000)) return fail(ErrorCode::usage, place + ": steps: expected a number from 1 to 100000, found " + std::to_string(*a.steps));
    return {};
}

} // namespace

Result<void> check_asset(const SceneAsset& asset, const std::set<std::string>& given, const std::string& place) {
    if (Result<void> fits = check_technique(asset, place); !fits) return fits;
    if (Result<void> fits = check_numbers(asset, place); !fits) return fits;
    for (const Rule& rule : rules)
        if (given.count(rule.key) > 0 && !rule.holds(asset)) return fail(ErrorCode::usage, place + ": " + rule.key + ": needs " + rule.wants);
    return check_features(asset, place);
}

Result<void> check_asset_name(const std::string& name, const std::string& place) {
    constexpr std::size_t longest = 100;
    const auto refused = [&](const std::string& words) { return fail(ErrorCode::usage, place + ": name: " + words); };
    if (name.empty()) return refused("expected one, found none");
    if (name.size() > longest) return refused("expected at most 100 bytes, found " + std::to_string(name.size()));
    for (const char c : name)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || std::string("/\\:*?\"<>|").find(c) != std::string::npos)
            return refused("becomes a file's name and cannot hold control characters or any of / \\ : * ? \" < > |");
    if (name.front() == '.' || name.front() == ' ' || name.front() == '-' || name.back() == '.' || name.back() == ' ')
        return refused("becomes a file's name and cannot begin with a dot, a dash or a blank or end with a dot or a blank; found '" + name + "'");
    return {};
}

} // namespace reliefbake

#include "cli/scene/scene_report.h"

#include "cli/choices.h"
#include "cli/report/format_text.h"
#include "cli/scene/bake_cost.h"
#include "cli/version.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace reliefbake {

using nlohmann::json;

namespace {

std::vector<std::string> feature_words(const SceneFeatures& features) {
    std::vector<std::string> words;
    const std::pair<bool, const char*> all[] = {{features.shadow, "shadow"}, {features.ao, "ao"}, {features.silhouette, "silhouette"}, {features.mips, "mips"}, {features.depth, "depth"}};
    for (const auto& [used, word] : all)
        if (used) words.push_back(word);
    return words;
}

/// What serves an asset, as "file (as)".
json serving(const SceneRun& run, std::size_t asset) {
    json maps = json::array();
    for (const SceneJob& job : run.plan.jobs)
        for (const SceneMap& map : job.maps)
            for (const SceneUse& use : map.uses)
                if (use.asset == asset) maps.push_back({{"map", map.output}, {"as", use.as}});
    return maps;
}

/// Why an asset, or a mesh of it, is not baked; empty: it is.
std::string left_out(const SceneAsset& asset) {
    if (!asset.is_placed) return "no primitive wears this material; not baked";
    if (needs_nothing(asset) && asset.technique == SceneTechnique::none) return "no technique and no feature needs it; not baked";
    if (!asset.mesh.empty() && !needs_quadrics(asset)) return "its mesh is not baked: quadrics are for the feature silhouette";
    return "";
}

json json_of(const SceneRun& run, const SceneMap& map) {
    json files = json::array(), uses = json::array();
    for (const SceneFile& file : map.files) {
        json one = {{"name", file.name}, {"width", file.width}, {"height", file.height}, {"channels", file.channels}, {"bits", file.bits}, {"bytes", file.bytes}};
        if (run.seconds) {
            std::error_code ignored;
            one["file_bytes"] = std::filesystem::file_size(run.folder + "/" + file.name, ignored);
        }
        files.push_back(std::move(one));
    }
    for (const SceneUse& use : map.uses) uses.push_back({{"asset", run.scene.assets[use.asset].name}, {"as", use.as}});
    return {{"output", map.output}, {"command", map.command}, {"what", map.what}, {"options", map.options}, {"bytes", map.bytes()}, {"predicted_seconds", predicted_seconds(map)}, {"uses", uses}, {"files", files}};
}

json assets_json(const SceneRun& run) {
    json assets = json::array();
    for (std::size_t k = 0; k < run.scene.assets.size(); ++k) {
        const SceneAsset& asset = run.scene.assets[k];
        const AssetFacts& facts = run.facts[k];
        json one = {{"name", asset.name}, {"technique", word_of(asset.technique)}, {"features", feature_words(asset.features)}, {"needed", !needs_nothing(asset)}, {"maps", serving(run, k)}, {"left_out", left_out(asset)}, {"choice", facts.note}};
        if (!asset.height.empty() && !needs_nothing(asset)) one["bits"] = word_of(bits_words, facts.bits), one["level"] = facts.level, one["stored_error"] = facts.stored_error;
        if (asset.technique == SceneTechnique::sectors) one["sectors"] = facts.sectors;
        assets.push_back(std::move(one));
    }
    return assets;
}

json everything_json(const ScenePlan& everything) {
    json maps = json::array();
    for (const SceneJob& job : everything.jobs)
        for (const SceneMap& map : job.maps) maps.push_back({{"input", job.input}, {"what", map.what}, {"bytes", map.bytes()}, {"predicted_seconds", predicted_seconds(map)}});
    return {{"bytes", everything.bytes()}, {"predicted_seconds", everything.predicted_seconds()}, {"maps", maps}};
}

std::string size_words(std::uint64_t bytes) { return bytes < 1000000 ? format("%.1f kB", double(bytes) / 1e3) : format("%.2f MB", double(bytes) / 1e6); }

std::string map_line(const SceneRun& run, const SceneMap& map) {
    std::string line = run.folder + "/" + map.output + ": " + map.what + ", " + size_words(map.bytes());
    if (map.files.size() > 1) line += " in " + std::to_string(map.files.size()) + " files";
    std::string options;
    for (const std::string& option : map.options) options += " " + option;
    line += " (" + map.command + options + ") for";
    for (std::size_t k = 0; k < map.uses.size(); ++k) line += (k ? ", '" : " '") + run.scene.assets[map.uses[k].asset].name + "' " + map.uses[k].as;
    return line + "\n";
}

std::string files_lines(const SceneRun& run) {
    std::string text;
    for (const SceneJob& job : run.plan.jobs)
        for (const SceneMap& map : job.maps) {
            text += map_line(run, map);
            for (std::size_t k = 1; k < map.files.size(); ++k) text += "  " + run.folder + "/" + map.files[k].name + "\n";
        }
    return text;
}

} // namespace

json scene_json(const SceneRun& run) {
    json runs = json::array();
    for (std::size_t k = 0; k < run.plan.jobs.size(); ++k) {
        const SceneJob& job = run.plan.jobs[k];
        json maps = json::array();
        for (const SceneMap& map : job.maps) maps.push_back(json_of(run, map));
        json one = {{"input", job.input}, {"source_options", job.source_options}, {"maps", maps}};
        if (run.seconds) one["seconds"] = (*run.seconds)[k];
        runs.push_back(std::move(one));
    }
    json whole = {{"scene", run.scene.file}, {"output", run.folder}, {"version", version()}, {"dry_run", !run.seconds}, {"assets", assets_json(run)}, {"runs", runs},
                  {"bytes", run.plan.bytes()}, {"predicted_seconds", run.plan.predicted_seconds()}, {"everything", everything_json(run.everything)},
                  {"saved_bytes", std::int64_t(run.everything.bytes()) - std::int64_t(run.plan.bytes())}};
    if (run.seconds) whole["seconds"] = std::accumulate(run.seconds->begin(), run.seconds->end(), 0.0);
    return whole;
}

std::string scene_summary(const SceneRun& run) {
    std::string text = files_lines(run);
    for (std::size_t k = 0; k < run.scene.assets.size(); ++k) {
        const std::string why = left_out(run.scene.assets[k]);
        if (!run.facts[k].note.empty()) text += "'" + run.scene.assets[k].name + "': " + run.facts[k].note + "\n";
        if (!why.empty()) text += "'" + run.scene.assets[k].name + "': " + why + "\n";
    }
    const double bytes = double(run.plan.bytes()), all = double(run.everything.bytes());
    text += size_words(run.plan.bytes()) + " of texels and vertices instead of " + size_words(run.everything.bytes()) + format(" for everything (%.1f %%); ", all > 0 ? 100 * bytes / all : 0);
    text += format("predicted %.2g s instead of %.2g s", run.plan.predicted_seconds(), run.everything.predicted_seconds());
    if (run.seconds) text += format("; baked in %.2g s", std::accumulate(run.seconds->begin(), run.seconds->end(), 0.0));
    return text + "\n";
}

} // namespace reliefbake

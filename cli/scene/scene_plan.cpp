#include "cli/scene/scene_plan.h"

#include "cli/report/format_text.h"
#include "cli/scene/bake_cost.h"
#include "cli/scene/scene_maps.h"

#include <algorithm>
#include <optional>
#include <set>

namespace reliefbake {
namespace {

/// A need of one asset, and what for.
struct OwnedNeed {
    MapNeed need;
    SceneUse use;
};

/// Needs of one source that are equal: one map serves them.
struct SharedNeed {
    MapNeed need;
    std::vector<SceneUse> uses;
};

SceneCones cones_of(const SceneAsset& asset, const AssetFacts& facts) {
    switch (asset.technique) {
    case SceneTechnique::relaxed: return SceneCones::relaxed;
    case SceneTechnique::cone_normal: return SceneCones::cone_normal;
    case SceneTechnique::sectors: return facts.sectors == 8 ? SceneCones::sectors_8 : SceneCones::sectors_4;
    case SceneTechnique::parallax: return asset.features.ao ? SceneCones::open : SceneCones::none;
    default: return SceneCones::cone;
    }
}

std::vector<OwnedNeed> needs_of(const Scene& scene, const std::vector<AssetFacts>& facts, std::size_t k) {
    const SceneAsset& asset = scene.assets[k];
    MapNeed need;
    need.bits = facts[k].bits, need.level = facts[k].level, need.mips = asset.features.mips;
    std::vector<OwnedNeed> needs;
    if (needs_relief_map(asset)) {
        MapNeed relief = need;
        relief.cones = cones_of(asset, facts[k]), relief.normals = true, relief.depth_scale = depth_scale_of(asset);
        relief.trilinear = asset.trilinear && relief.cones != SceneCones::none && relief.cones != SceneCones::relaxed;
        needs.push_back({relief, {k, "relief"}});
    }
    if (needs_ambient(asset)) {
        MapNeed ambient = need;
        ambient.cones = SceneCones::open, ambient.trilinear = asset.trilinear;
        needs.push_back({ambient, {k, "ambient"}});
    }
    return needs;
}

/// Assets that read the same image in the same way.
std::string source_key(const SceneAsset& asset) {
    std::string key = asset.height.empty() ? "shape\n" + asset.shape : "height\n" + asset.height;
    for (const std::string& option : source_options(asset)) key += "\n" + option;
    return key;
}

struct SourceGroup {
    std::string key;
    std::vector<std::size_t> assets;
};

/// By their sources, in the order of the first asset of each.
template <class KeyOf>
std::vector<SourceGroup> grouped(const Scene& scene, KeyOf key_of) {
    std::vector<SourceGroup> groups;
    for (std::size_t k = 0; k < scene.assets.size(); ++k) {
        const std::string key = key_of(scene.assets[k]);
        if (key.empty()) continue;
        const auto known = std::find_if(groups.begin(), groups.end(), [&](const SourceGroup& group) { return group.key == key; });
        if (known != groups.end()) known->assets.push_back(k);
        else groups.push_back({key, {k}});
    }
    return groups;
}

const char* suffix_of(const SceneUse& use) { return use.as == "ambient" ? "_ambient" : use.as == "horizons" ? "_horizon" : use.as == "quadrics" ? "_quadrics" : ""; }

MapPlace place_of(const Scene& scene, const std::vector<AssetFacts>& facts, const SceneUse& first) {
    return {scene.assets[first.asset].name + suffix_of(first), scene.extension, facts[first.asset].width, facts[first.asset].height};
}

SceneJob job_of(const SceneAsset& asset, std::optional<double> depth_scale) {
    SceneJob job{asset.height.empty() ? asset.shape : asset.height, source_options(asset), {}};
    if (depth_scale) job.source_options.insert(job.source_options.end(), {"--depth-uv", digits(*depth_scale)});
    return job;
}

/// Maps of cones and depth of one source; a run for each depth scale, which all of its maps share.
Result<void> add_relief_jobs(const Scene& scene, const std::vector<AssetFacts>& facts, const SourceGroup& group, ScenePlan& plan) {
    std::vector<SharedNeed> shared;
    for (const std::size_t k : group.assets)
        for (const OwnedNeed& owned : needs_of(scene, facts, k)) {
            if (!scene.assets[k].is_placed) continue;
            const auto known = std::find_if(shared.begin(), shared.end(), [&](const SharedNeed& one) { return one.need == owned.need; });
            if (known != shared.end()) known->uses.push_back(owned.use);
            else shared.push_back({owned.need, {owned.use}});
        }
    if (shared.empty()) return {};
    const std::size_t first = group.assets.front();
    if (shared.size() > most_needs)
        return fail(ErrorCode::budget, scene.file + ": " + scene.assets[first].height + ": its assets have " + std::to_string(shared.size()) + " different needs; expected at most " +
                                           std::to_string(most_needs) + " of one source: give some the same sizes and budgets");
    std::vector<MapNeed> needs;
    for (const SharedNeed& one : shared) needs.push_back(one.need);
    std::vector<std::pair<std::optional<double>, SceneJob>> jobs;
    for (const std::vector<std::size_t>& part : cheapest_maps(needs, facts[first].width, facts[first].height)) {
        MapNeed need = needs[part.front()];
        std::vector<SceneUse> uses;
        for (const std::size_t k : part) {
            need = *joined(need, needs[k]);
            uses.insert(uses.end(), shared[k].uses.begin(), shared[k].uses.end());
        }
        std::stable_sort(uses.begin(), uses.end(), [](const SceneUse& a, const SceneUse& b) { return a.asset < b.asset; });
        auto job = std::find_if(jobs.begin(), jobs.end(), [&](const auto& known) { return !need.depth_scale || !known.first || known.first == need.depth_scale; });
        if (job == jobs.end()) job = jobs.insert(job, {need.depth_scale, SceneJob()});
        if (!job->first) job->first = need.depth_scale;
        for (SceneMap& map : relief_maps(need, place_of(scene, facts, uses.front()))) {
            map.uses = uses;
            job->second.maps.push_back(std::move(map));
        }
    }
    for (auto& [depth_scale, maps] : jobs) {
        SceneJob job = job_of(scene.assets[first], depth_scale);
        job.maps = std::move(maps.maps);
        plan.jobs.push_back(std::move(job));
    }
    return {};
}

using WantsBump = bool (*)(const SceneAsset&);

/// Normals or horizons of one source: one map for each depth scale, as fine as the finest that is asked for.
void add_bump_jobs(const Scene& scene, const std::vector<AssetFacts>& facts, const SourceGroup& group, WantsBump wants, const char* as, ScenePlan& plan) {
    std::vector<std::pair<double, std::vector<SceneUse>>> by_depth;
    for (const std::size_t k : group.assets) {
        const SceneAsset& asset = scene.assets[k];
        if (!asset.is_placed || !wants(asset)) continue;
        const double depth = depth_scale_of(asset);
        const auto known = std::find_if(by_depth.begin(), by_depth.end(), [&](const auto& one) { return one.first == depth; });
        if (known != by_depth.end()) known->second.push_back({k, as});
        else by_depth.push_back({depth, {{k, as}}});
    }
    for (const auto& [depth, uses] : by_depth) {
        BitDepth bits = BitDepth::unorm8;
        for (const SceneUse& use : uses) bits = std::max(bits, facts[use.asset].bits);
        SceneJob job = job_of(scene.assets[uses.front().asset], depth);
        const MapPlace place = place_of(scene, facts, uses.front());
        job.maps.push_back(wants == needs_horizons ? horizon_map(bits, place) : normal_map(bits, place));
        job.maps.back().uses = uses;
        plan.jobs.push_back(std::move(job));
    }
}

void add_shape_job(const Scene& scene, const std::vector<AssetFacts>& facts, const SourceGroup& group, ScenePlan& plan) {
    std::vector<SceneUse> uses;
    for (const std::size_t k : group.assets)
        if (scene.assets[k].is_placed && needs_shape_map(scene.assets[k])) uses.push_back({k, "shape"});
    if (uses.empty()) return;
    SceneJob job = job_of(scene.assets[uses.front().asset], {});
    job.maps.push_back(shape_map(place_of(scene, facts, uses.front())));
    job.maps.back().uses = uses;
    plan.jobs.push_back(std::move(job));
}

void add_quadric_job(const Scene& scene, const std::vector<AssetFacts>& facts, const SourceGroup& group, ScenePlan& plan) {
    std::vector<SceneUse> uses;
    for (const std::size_t k : group.assets)
        if (scene.assets[k].is_placed && needs_quadrics(scene.assets[k])) uses.push_back({k, "quadrics"});
    if (uses.empty()) return;
    const std::size_t first = uses.front().asset;
    SceneJob job{scene.assets[first].mesh, {}, {quadric_mesh(place_of(scene, facts, uses.front()).name, facts[first].mesh_bytes, facts[first].mesh_vertices)}};
    job.maps.back().uses = uses;
    plan.jobs.push_back(std::move(job));
}

std::string image_key(const SceneAsset& asset) { return asset.height.empty() && asset.shape.empty() ? std::string() : source_key(asset); }
std::string mesh_key(const SceneAsset& asset) { return asset.mesh; }

MapNeed everything_of(SceneCones cones, double depth_scale) {
    MapNeed need;
    need.cones = cones, need.normals = true, need.mips = true, need.depth_scale = depth_scale;
    need.trilinear = cones != SceneCones::relaxed;
    return need;
}

} // namespace

std::uint64_t SceneMap::bytes() const {
    std::uint64_t sum = 0;
    for (const SceneFile& file : files) sum += file.bytes;
    return sum;
}

std::uint64_t ScenePlan::bytes() const {
    std::uint64_t sum = 0;
    for (const SceneJob& job : jobs)
        for (const SceneMap& map : job.maps) sum += map.bytes();
    return sum;
}

double ScenePlan::predicted_seconds() const {
    double sum = 0;
    for (const SceneJob& job : jobs)
        for (const SceneMap& map : job.maps) sum += reliefbake::predicted_seconds(map);
    return sum;
}

Result<ScenePlan> plan_scene(const Scene& scene, const std::vector<AssetFacts>& facts) {
    ScenePlan plan;
    for (const SourceGroup& group : grouped(scene, image_key)) {
        if (Result<void> added = add_relief_jobs(scene, facts, group, plan); !added) return tl::unexpected(added.error());
        add_bump_jobs(scene, facts, group, needs_normal_map, "normals", plan);
        add_bump_jobs(scene, facts, group, needs_horizons, "horizons", plan);
        add_shape_job(scene, facts, group, plan);
    }
    for (const SourceGroup& group : grouped(scene, mesh_key)) add_quadric_job(scene, facts, group, plan);
    return plan;
}

ScenePlan plan_everything(const Scene& scene, const std::vector<AssetFacts>& facts) {
    ScenePlan plan;
    int number = 0;
    for (const SourceGroup& group : grouped(scene, image_key)) {
        const std::size_t first = group.assets.front();
        const SceneAsset& asset = scene.assets[first];
        const auto place = [&](const char* suffix) {
            return MapPlace{"source" + std::to_string(number) + suffix, scene.extension, facts[first].width, facts[first].height};
        };
        ++number;
        if (asset.height.empty()) {
            SceneJob job = job_of(asset, {});
            job.maps.push_back(shape_map(place("")));
            plan.jobs.push_back(std::move(job));
            continue;
        }
        const double depth = depth_scale_of(asset);
        SceneJob job = job_of(asset, depth);
        const std::pair<SceneCones, const char*> kinds[] = {{SceneCones::cone, "_cone"}, {SceneCones::relaxed, "_relaxed"}, {SceneCones::cone_normal, "_cone_normal"}, {SceneCones::sectors_4, "_4"}, {SceneCones::sectors_8, "_8"}};
        for (const auto& [cones, suffix] : kinds)
            for (SceneMap& map : relief_maps(everything_of(cones, depth), place(suffix))) job.maps.push_back(std::move(map));
        plan.jobs.push_back(std::move(job));
        SceneAsset solid = asset; // bump maps know no holes
        solid.alpha.clear();
        for (const bool horizons : {false, true}) {
            SceneJob bump = job_of(solid, depth);
            bump.maps.push_back(horizons ? horizon_map(BitDepth::unorm16, place("_horizon")) : normal_map(BitDepth::unorm16, place("_normal")));
            plan.jobs.push_back(std::move(bump));
        }
    }
    for (const SourceGroup& group : grouped(scene, mesh_key)) {
        const std::size_t first = group.assets.front();
        plan.jobs.push_back({scene.assets[first].mesh, {}, {quadric_mesh("source" + std::to_string(number++), facts[first].mesh_bytes, facts[first].mesh_vertices)}});
    }
    return plan;
}

} // namespace reliefbake

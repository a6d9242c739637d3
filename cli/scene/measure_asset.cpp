#include "cli/scene/measure_asset.h"

#include "cli/report/format_text.h"
#include "cli/tradeoff/measure_candidate.h"
#include "cli/tradeoff/method.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace reliefbake {
namespace {

constexpr int judged_rays = 14000, halvings = 8;

struct Choice {
    int level, sectors;
    std::uint64_t bytes;
};

const Method& method_of(const SceneAsset& asset, int sectors) {
    const char* word = asset.technique == SceneTechnique::relaxed       ? "relaxed"
                       : asset.technique == SceneTechnique::cone_normal ? "cone-normal"
                       : asset.technique == SceneTechnique::sectors     ? (sectors == 8 ? "sectors-8" : "sectors-4")
                                                                        : "cone";
    const Method* method = find_method(word);
    assert(method);
    return *method;
}

std::vector<Choice> choices_of(const SceneAsset& asset, const AssetFacts& chosen) {
    const bool free = asset.technique == SceneTechnique::sectors && !asset.sectors;
    std::vector<Choice> choices;
    for (int level = chosen.level; level >= 0; --level)
        for (const int sectors : {4, 8}) {
            if (!free && sectors != chosen.sectors) continue;
            MapNeed need;
            need.cones = asset.technique != SceneTechnique::sectors ? SceneCones::cone : sectors == 8 ? SceneCones::sectors_8 : SceneCones::sectors_4;
            need.normals = true, need.level = level, need.mips = asset.features.mips, need.bits = chosen.bits;
            choices.push_back({level, sectors, bytes_of(need, chosen.width, chosen.height)});
        }
    std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return std::tuple(a.bytes, b.level, a.sectors) < std::tuple(b.bytes, a.level, b.sectors); });
    return choices;
}

Candidate candidate_of(const SceneAsset& asset, const AssetFacts& chosen, const Choice& choice) {
    Candidate candidate = method_of(asset, choice.sectors).base;
    candidate.map.bits = chosen.bits, candidate.map.level = choice.level;
    candidate.march.steps = *asset.steps;
    if (technique_info(candidate.march.technique).refines) candidate.march.refinements = halvings;
    return candidate;
}

} // namespace

Result<MeasuredChoice> measure_choices(const SceneAsset& asset, const AssetFacts& chosen, const BakeSource& source, int threads, const std::string& place) {
    JudgeOptions judge;
    judge.steepest = *asset.angle, judge.rays = judged_rays, judge.repeat = 1, judge.threads = threads;
    Result<CandidateMeter> meter = CandidateMeter::create(source, depth_scale_of(asset), judge);
    if (!meter) return tl::unexpected(meter.error());
    MeasuredChoice best{0, 4, 2};
    for (const Choice& choice : choices_of(asset, chosen)) {
        const Result<Measurement> figures = meter->measure(candidate_of(asset, chosen, choice));
        if (!figures) return fail(figures.error().code, place + ": max_wrong: " + figures.error().message);
        const double wrong = figures->missed + figures->early;
        if (wrong < best.wrong) best = {choice.level, choice.sectors, wrong};
        if (wrong <= *asset.max_wrong) return MeasuredChoice{choice.level, choice.sectors, wrong};
    }
    std::string found = asset.technique == SceneTechnique::sectors ? " with " + std::to_string(best.sectors) + " sectors" : "";
    return fail(ErrorCode::budget, place + ": max_wrong: expected a share of at most " + digits(*asset.max_wrong) + " of the rays in " + std::to_string(*asset.steps) + " steps, found " +
                                       format("%.3g", best.wrong) + found + " at best; allow more steps or more wrong rays");
}

} // namespace reliefbake

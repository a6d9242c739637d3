#include "cli/advise/advice_plan.h"

#include "cli/cone/cone_info.h"

#include <algorithm>

namespace reliefbake {
namespace {

constexpr int most_halvings = 8;   ///< of GPU Gems 3, chapter 18
constexpr int coarsest_level = 2;  ///< a sixteenth of the texels
constexpr int plenty = 1024;       ///< of steps: no march over a pyramid of 65536 texels a side is as long
constexpr BitDepth depths[] = {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32};

bool can_filter(ShaderTarget target, BitDepth bits) {
    switch (target) {
    case ShaderTarget::glsl: return true;
    case ShaderTarget::glsl_es: return bits == BitDepth::unorm8 || bits == BitDepth::half;
    case ShaderTarget::hlsl: return bits != BitDepth::float32;
    }
    return false;
}

bool can_follow(ShaderTarget target, const March& march) {
    return target != ShaderTarget::hlsl || (technique_info(march.technique).cones && !march.exact_finish);
}

/// Whether the field has the level: a chain ends at 1 x 1.
bool has_level(int width, int height, int level) { return (std::max(width, height) >> level) >= 1; }

std::vector<Candidate> marches_of(Candidate candidate, int steps) {
    std::vector<Candidate> marches;
    for (const int rounds : march_lengths(steps)) {
        const bool refines = technique_info(candidate.march.technique).refines;
        candidate.march.refinements = refines ? std::min(most_halvings, rounds / 3) : 0;
        const bool linear = technique_info(candidate.march.technique).steps == TechniqueInfo::Steps::linear;
        candidate.march.steps = rounds - candidate.march.refinements - (linear ? 1 : 0); // which looks at both ends of its steps
        if (candidate.march.steps > 0 && (!refines || candidate.march.refinements > 0)) marches.push_back(candidate);
    }
    return marches;
}

} // namespace

double source_bytes_per_texel(const Candidate& candidate, int width, int height) {
    const int level = candidate.map.level;
    const double texels = double(std::max(1, width >> level)) * double(std::max(1, height >> level));
    return texels * bytes_per_texel(candidate) / (double(width) * double(height));
}

Candidate probe_of(const StoredSurface& surface) {
    Candidate probe;
    probe.map.kind = "height", probe.map.bits = surface.bits, probe.map.level = surface.level;
    probe.march = {Technique::max_mip, false, plenty, 0};
    return probe;
}

bool misses_none(const Candidate& candidate) {
    if (candidate.map.level > 0) return false;
    if (!candidate.map.has_cones()) return candidate.march.technique == Technique::max_mip;
    const std::string guarantee = guarantee_of(candidate.map.cone);
    return guarantee == "C" || (guarantee == "R" && technique_info(candidate.march.technique).refines);
}

std::vector<int> march_lengths(int steps) {
    std::vector<int> lengths{steps};
    for (const int rounds : {64, 32, 16, 8, 4})
        if (rounds < steps) lengths.push_back(rounds);
    return lengths;
}

AdvicePlan plan_advice(int width, int height, const Budget& budget, ShaderTarget target, const std::function<bool(const Representation&)>& can_hold) {
    AdvicePlan plan;
    for (const BitDepth bits : depths)
        for (int level = 0; level <= coarsest_level && has_level(width, height, level); ++level)
            for (const Method& method : all_methods()) {
                const auto allowed = [&](const Candidate& candidate) {
                    return can_follow(target, candidate.march) && can_filter(target, candidate.map.bits) && can_hold(candidate.map);
                };
                Candidate candidate = method.base, sixteen;
                candidate.map.bits = bits, candidate.map.level = level;
                if (candidate.map.encoding != ConeEncoding::normal) candidate.map.encoding = bits == BitDepth::unorm8 ? ConeEncoding::sqrt : ConeEncoding::ratio;
                sixteen = candidate, sixteen.map.bits = BitDepth::unorm16;
                if (!method.by_default || !allowed(candidate) || (budget.max_missed == 0 && !misses_none(candidate))) continue;
                if (bits == BitDepth::half && allowed(sixteen)) continue; // as many bytes, and coarser
                if (bits == BitDepth::float32 && level > 0) continue;     // what a coarser map loses is more than its codes
                Way way{&method, source_bytes_per_texel(candidate, width, height), marches_of(candidate, budget.steps)};
                if (way.marches.empty()) continue;
                (way.bytes_per_texel <= budget.bytes_per_texel ? plan.ways : plan.too_large).push_back(std::move(way));
            }
    for (std::vector<Way>* ways : {&plan.ways, &plan.too_large})
        std::stable_sort(ways->begin(), ways->end(), [](const Way& a, const Way& b) { return a.bytes_per_texel < b.bytes_per_texel; });
    return plan;
}

} // namespace reliefbake

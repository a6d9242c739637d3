#include "cli/tradeoff/candidate.h"

#include "cli/choices.h"
#include "cli/report/format_text.h"
#include "formats/shortest_decimal.h"

#include <cmath>

namespace reliefbake {
namespace {

constexpr double pyramid_bytes = 4.0 * 4 / 3; ///< a float a cell, and a third of that in all levels above

std::string number(float value) { return digits(shortest_decimal(value)); }

std::string family_of(const ConeOptions& cone) {
    if (cone.family == ConeFamily::conservative) return "";
    if (cone.family == ConeFamily::hybrid) return "hybrid" + number(cone.hybrid_delta);
    switch (cone.rays) {
    case RelaxedRays::strict:
        return "relaxed";
    case RelaxedRays::top:
        return "relaxed-top";
    case RelaxedRays::slope:
        return "relaxed-slope" + number(cone.relaxed_slope);
    }
    return "";
}

std::string shape_of(const Representation& map) {
    const std::string family = family_of(map.cone);
    std::string shape = family.empty() ? "cone" : family;
    if (map.kind != "cone") {
        const std::string name = map.kind == "acm" ? "sectors" : map.kind == "cone-stack" ? "stack" : "pieces";
        shape = name + std::to_string(map.planes) + (family.empty() ? "" : "-" + family);
    }
    if (map.cone.lookup == ConeLookup::cell) shape += "-cell";
    if (map.cone.surface == SurfaceModel::texel) shape += "-texel";
    if (map.cone.metric == Metric::l1) shape += "-l1";
    return shape;
}

int sample_bytes(BitDepth bits) { return bits == BitDepth::unorm8 ? 1 : bits == BitDepth::float32 ? 4 : 2; }

} // namespace

bool operator==(const Representation& a, const Representation& b) { return id_of(a) == id_of(b); }

double resolution_of(const Representation& map) { return std::ldexp(1.0, -map.level); }

std::string id_of(const Representation& map) {
    const std::string tail = word_of(bits_words, map.bits);
    const std::string resolution = "_res" + digits(resolution_of(map));
    if (!map.has_cones()) return "height_" + tail + resolution;
    return shape_of(map) + "_" + word_of(encoding_words, map.encoding) + "_" + tail + "_t" + number(map.cone.tolerance) + "_m" +
           number(map.cone.ratio_max) + resolution;
}

std::string id_of(const March& march) {
    const TechniqueInfo& info = technique_info(march.technique);
    std::string id = std::string(info.word) + (march.exact_finish ? "-exact" : "");
    if (info.steps != TechniqueInfo::Steps::none) id += "_n" + std::to_string(march.steps);
    if (info.refines) id += "_r" + std::to_string(march.refinements);
    return id;
}

std::string id_of(const Candidate& candidate) { return id_of(candidate.map) + "_" + id_of(candidate.march); }

Result<void> check_candidate(const Candidate& candidate) {
    const Representation& map = candidate.map;
    const TechniqueInfo& info = technique_info(candidate.march.technique);
    const std::string word(info.word);
    const bool floats = !is_unorm(map.bits);
    const bool unbounded = map.encoding == ConeEncoding::normal || (map.encoding == ConeEncoding::radius && floats);
    if (map.has_cones() && !std::isfinite(map.cone.ratio_max) && !unbounded)
        return fail(ErrorCode::usage, "cones without a cap need encoding normal, or radius in floats");
    if (info.cones && !map.has_cones()) return fail(ErrorCode::usage, "technique " + word + " needs cones");
    if (map.has_cones() && map.kind == "cone" && map.cone.family == ConeFamily::relaxed && info.technique == Technique::cone)
        return fail(ErrorCode::usage, "relaxed cones need a technique that refines");
    if (candidate.march.exact_finish && info.technique != Technique::cone && info.technique != Technique::cone_raw)
        return fail(ErrorCode::usage, "technique " + word + " has no exact finish");
    if (info.steps != TechniqueInfo::Steps::none && candidate.march.steps < 1) return fail(ErrorCode::usage, "technique " + word + " needs a step at least");
    return {};
}

double bytes_per_texel(const Candidate& candidate) {
    constexpr int normal_and_depth = 3;
    const int cones = candidate.map.has_cones() ? candidate.map.planes : 0;
    const double channels = double(sample_bytes(candidate.map.bits)) * (normal_and_depth + cones);
    return channels + (candidate.march.technique == Technique::max_mip ? pyramid_bytes : 0);
}

} // namespace reliefbake

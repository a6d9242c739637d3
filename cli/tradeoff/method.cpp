#include "cli/tradeoff/method.h"

#include <limits>
#include <vector>

namespace reliefbake {
namespace {

constexpr float hybrid_delta = 0.05f;
constexpr int stacked_levels = 3;

Candidate height(Technique technique) {
    Candidate candidate;
    candidate.map.kind = "height";
    candidate.march.technique = technique;
    return candidate;
}

Candidate cones(Technique technique, ConeFamily family, RelaxedRays rays = RelaxedRays::strict) {
    Candidate candidate;
    candidate.map.cone.family = family, candidate.map.cone.rays = rays;
    candidate.march.technique = technique;
    return candidate;
}

Candidate planes(std::string kind, int count) {
    Candidate candidate;
    candidate.map.kind = std::move(kind), candidate.map.planes = count;
    return candidate;
}

std::vector<Method> make_methods() {
    const Candidate conservative = cones(Technique::cone, ConeFamily::conservative);
    Candidate hybrid = cones(Technique::cone, ConeFamily::hybrid), normal = conservative, exact = conservative, cell = conservative;
    hybrid.map.cone.hybrid_delta = hybrid_delta;
    normal.map.encoding = ConeEncoding::normal, normal.map.cone.ratio_max = std::numeric_limits<float>::infinity();
    exact.march.exact_finish = true;
    cell.map.cone.lookup = ConeLookup::cell;
    return {{"linear", "linear", true, height(Technique::linear)},
            {"binary", "linear + binary", true, height(Technique::binary)},
            {"interval", "linear + interval", true, height(Technique::interval)},
            {"cone", "cone stepping", true, conservative},
            {"relaxed", "relaxed, strict", true, cones(Technique::relaxed, ConeFamily::relaxed)},
            {"relaxed-top", "relaxed, top", true, cones(Technique::relaxed, ConeFamily::relaxed, RelaxedRays::top)},
            {"hybrid", "hybrid, delta 0.05", true, hybrid},
            {"sectors-4", "4 sectors", true, planes("acm", 4)},
            {"sectors-8", "8 sectors", true, planes("acm", 8)},
            {"cone-normal", "cone normal", true, normal},
            {"stacked", "3 stacked cones", true, planes("cone-stack", stacked_levels)},
            {"max-mip", "maximum mipmaps", true, height(Technique::max_mip)},
            {"exact-finish", "cone + exact finish", true, exact},
            {"cone-cell", "cone, cell lookup", false, cell},
            {"pieces", "3 pieces", false, planes("cone-pieces", stacked_levels)},
            {"relaxed-secant", "relaxed + secants", false, cones(Technique::relaxed_secant, ConeFamily::relaxed)}};
}

} // namespace

std::span<const Method> all_methods() {
    static const std::vector<Method> methods = make_methods();
    return methods;
}

const Method* find_method(std::string_view word) {
    for (const Method& method : all_methods())
        if (method.word == word) return &method;
    return nullptr;
}

} // namespace reliefbake

#include "shaders-reference/renderer/technique.h"

#include <cassert>

namespace reliefbake {
namespace {

using Steps = TechniqueInfo::Steps;

constexpr int march_steps = 256;
constexpr int linear_steps = 64;
constexpr int relaxed_steps = 15; ///< GPU Gems 3, chapter 18; so are its 8 halvings

const std::vector<TechniqueInfo>& table() {
    static const std::vector<TechniqueInfo> rows = {
        {Technique::cone, "cone", "cone_march", {"patch_hit.glsl", "cone_march.glsl"}, true, Steps::march, march_steps, false},
        {Technique::cone_published, "cone-published", "cone_march_published", {"cone_march_published.glsl"}, true, Steps::march, march_steps, false},
        {Technique::cone_raw, "cone-raw", "cone_march", {"patch_hit.glsl", "cone_march.glsl"}, true, Steps::march, march_steps, false},
        {Technique::relaxed, "relaxed", "relaxed_march", {"patch_hit.glsl", "bracket.glsl", "relaxed_bracket.glsl", "relaxed_march.glsl"}, true, Steps::march, relaxed_steps, true},
        {Technique::relaxed_secant, "relaxed-secant", "relaxed_secant", {"patch_hit.glsl", "bracket.glsl", "relaxed_bracket.glsl", "relaxed_secant.glsl"}, true, Steps::march, relaxed_steps, true},
        {Technique::linear, "linear", "linear_search", {"bracket.glsl", "linear_bracket.glsl", "linear_search.glsl"}, false, Steps::linear, linear_steps, false},
        {Technique::binary, "binary", "binary_search", {"bracket.glsl", "linear_bracket.glsl", "binary_search.glsl"}, false, Steps::linear, linear_steps, true},
        {Technique::interval, "interval", "interval_mapping", {"bracket.glsl", "linear_bracket.glsl", "interval_mapping.glsl"}, false, Steps::linear, linear_steps, true},
        {Technique::dynamic, "dynamic", "dynamic_search", {"bracket.glsl", "linear_bracket.glsl", "dynamic_search.glsl"}, false, Steps::linear, linear_steps, true},
        {Technique::pom, "pom", "parallax_occlusion", {"bracket.glsl", "linear_bracket.glsl", "parallax_occlusion.glsl"}, false, Steps::linear, linear_steps, false},
        {Technique::steep, "steep", "steep_parallax", {"bracket.glsl", "linear_bracket.glsl", "steep_parallax.glsl"}, false, Steps::linear, linear_steps, false},
        {Technique::parallax, "parallax", "parallax", {"parallax.glsl"}, false, Steps::none, 0, false},
        {Technique::parallax_limited, "parallax-limited", "parallax_limited", {"parallax.glsl", "parallax_limited.glsl"}, false, Steps::none, 0, false},
        {Technique::max_mip, "max-mip", "max_mip", {"patch_hit.glsl", "max_mip.glsl"}, false, Steps::march, march_steps, false},
        {Technique::given, "", "given_hit", {"given_hits.glsl"}, false, Steps::none, 0, false},
    };
    return rows;
}

} // namespace

std::span<const TechniqueInfo> all_techniques() { return table(); }

const TechniqueInfo& technique_info(Technique technique) {
    for (const TechniqueInfo& row : table())
        if (row.technique == technique) return row;
    assert(!"every technique has a row");
    return table().front();
}

Technique suitable_technique(const ReliefMap& map) {
    if (!has_cones(map)) return Technique::max_mip;
    return map.info.family == ConeFamily::relaxed ? Technique::relaxed : Technique::cone;
}

} // namespace reliefbake

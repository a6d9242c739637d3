#include "cli/advise/bake_command_text.h"

#include "cli/choices.h"
#include "cli/report/format_text.h"
#include "formats/shortest_decimal.h"

#include <cmath>

namespace reliefbake {
namespace {

std::string family_text(const ConeOptions& cone) {
    std::string text = cone.family == ConeFamily::conservative ? "" : " --kind " + word_of(family_words, cone.family);
    if (cone.family == ConeFamily::hybrid) return text + " --delta " + digits(shortest_decimal(cone.hybrid_delta));
    if (cone.family == ConeFamily::relaxed && cone.rays == RelaxedRays::top) return text + " --relaxed top";
    return text;
}

} // namespace

std::string bake_command_text(const Representation& map) {
    std::string text = map.kind;
    if (map.kind == "acm") text += " --sectors " + std::to_string(map.planes);
    if (map.kind == "cone-stack") text += " --levels " + std::to_string(map.planes);
    if (!map.has_cones()) text = "cone --channels normal,depth";
    const bool unbounded = std::isinf(map.cone.ratio_max); // encoding normal is the command's own
    if (map.kind == "cone" && unbounded) text = "cone-normal";
    if (map.has_cones()) text += family_text(map.cone);
    text += " --bits " + word_of(bits_words, map.bits);
    if (map.has_cones() && !unbounded) text += " --encoding " + word_of(encoding_words, map.encoding);
    if (map.level > 0) text += " --level " + std::to_string(map.level);
    return text;
}

std::string march_text(const March& march) {
    const TechniqueInfo& info = technique_info(march.technique);
    std::string text = "--technique " + std::string(info.word) + (march.exact_finish ? " --exact-finish" : "");
    text += " --steps " + std::to_string(march.steps);
    if (info.refines) text += " --binary-steps " + std::to_string(march.refinements);
    return text;
}

} // namespace reliefbake

#include "cli/tradeoff/instruction_cost.h"

#include <algorithm>

namespace reliefbake {
namespace {

constexpr InstructionCount counts[] = {
    {"linear", 173, 18, 0, 0},
    {"binary", 175, 18, 17, 0},
    {"interval", 175, 18, 24, 0},
    {"cone", 187, 33, 0, 193},
    {"relaxed", 205, 33, 16, 184},
    {"cone sectors4", 196, 35, 0, 193},
    {"cone sectors8", 219, 37, 0, 193},
    {"cone stacked3", 187, 108, 0, 193},
    {"max-mip", 187, 71, 0, 204},
    {"cone exact", 187, 48, 0, 173},
    {"cone cell", 187, 65, 0, 187},
    {"relaxed-secant", 205, 33, 23, 184},
};

} // namespace

std::span<const InstructionCount> instruction_counts() { return counts; }

std::string instruction_program(const Candidate& candidate) {
    const Representation& map = candidate.map;
    const TechniqueInfo& info = technique_info(candidate.march.technique);
    std::string program(info.word);
    if (candidate.march.exact_finish) program += " exact";
    if (!info.cones) return program;
    if (map.kind == "acm") program += " sectors" + std::to_string(map.planes);
    if (map.kind == "cone-stack") program += " stacked" + std::to_string(map.planes);
    if (map.kind == "cone-pieces") program += " pieces" + std::to_string(map.planes);
    if (map.cone.lookup == ConeLookup::cell) program += " cell";
    return program;
}

double instruction_cost(const Candidate& candidate, double steps, double refining, double fetches) {
    const std::string program = instruction_program(candidate);
    for (const InstructionCount& count : counts) {
        if (count.program != program) continue;
        const bool exact = candidate.march.exact_finish || candidate.march.technique == Technique::max_mip;
        const double patches = exact ? std::max(0.0, fetches - steps) / 4 : 0;
        return count.outside + (steps - refining) * count.step + refining * count.refinement + patches * count.patch;
    }
    return 0;
}

} // namespace reliefbake

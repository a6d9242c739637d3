#include "cli/tradeoff/instruction_cost.h"

#include <algorithm>

namespace reliefbake {
namespace {

constexpr InstructionCount counts[] = {
    {"", 0, 0, 0},
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

double instruction_cost(const Candidate& candidate, double steps_mean) {
    const std::string program = instruction_program(candidate);
    for (const InstructionCount& count : counts) {
        if (count.program != program) continue;
        const double refining = std::min<double>(candidate.march.refinements, steps_mean);
        return count.outside + (steps_mean - refining) * count.step + refining * count.refinement;
    }
    return 0;
}

} // namespace reliefbake

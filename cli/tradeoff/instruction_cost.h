#pragma once
// What a march costs in instructions, on no machine in particular.

#include "cli/tradeoff/candidate.h"

#include <span>
#include <string_view>

namespace reliefbake {

/// SPIR-V instructions of a program's march, by `tests/instruction_table.sh`: glslang's code, optimised and inlined by spirv-opt -O.
struct InstructionCount {
    std::string_view program; ///< instruction_program of the candidates it serves
    int outside;  ///< of the whole program outside of its loops: shading and set-up too
    int step;     ///< of one round of the march's loop, every branch of it counted
    int refinement; ///< of one round of the refining loop; 0 without
};

std::span<const InstructionCount> instruction_counts();

/// What decides a candidate's program, e.g. "cone sectors8", "relaxed".
std::string instruction_program(const Candidate& candidate);

/// outside + rounds of each loop times its instructions. `steps_mean`: of both loops; the last `refinements` of them refine.
/// 0 where the program is in no table.
double instruction_cost(const Candidate& candidate, double steps_mean);

} // namespace reliefbake

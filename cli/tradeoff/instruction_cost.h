#pragma once
// What a march costs in instructions, on no machine in particular.

#include "cli/tradeoff/candidate.h"

#include <span>
#include <string_view>

namespace reliefbake {

/// SPIR-V instructions of a program that glslang compiled and spirv-opt -O inlined and optimised; test_instruction_cost.cpp counts again.
struct InstructionCount {
    std::string_view program; ///< instruction_program of the candidates it serves
    int outside;    ///< of its loops: set-up and shading
    int step;       ///< of the shortest way through a round of the march that goes on: what nearly every round takes; with all levels of stacked cones
    int refinement; ///< of a round that refines; 0 without
    int patch;      ///< what the longest way takes more: the exact patch test
};

std::span<const InstructionCount> instruction_counts();

/// What decides a candidate's program, e.g. "cone sectors8", "relaxed".
std::string instruction_program(const Candidate& candidate);

/// Instructions of a ray: `outside`, and for each round of a loop its own. `steps`: mean of both loops, of which
/// `refining` refine. Of exact techniques, which fetch once a step, four fetches more are a patch test.
/// 0 where the program is in no table: pieces of cones, whose loop ends where the ray is.
double instruction_cost(const Candidate& candidate, double steps, double refining, double fetches);

} // namespace reliefbake

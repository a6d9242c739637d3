#pragma once
// The choice among measured candidates: pure, and apart from measuring.

#include "cli/advise/budget.h"
#include "cli/tradeoff/candidate.h"

#include <optional>
#include <span>

namespace reliefbake {

struct Trial {
    Candidate candidate;
    Measurement figures;
};

/// Order of cost: bytes for a texel of the source, then texture reads of a ray, then instructions (those not counted last), then mean
/// error, then the id. Of two different candidates exactly one is cheaper.
bool is_cheaper(const Trial& a, const Trial& b);

/// Whether two candidates are one map followed by one technique: only steps and refinements may differ.
bool is_same_way(const Candidate& a, const Candidate& b);

/// Indices.
struct Choice {
    std::optional<std::size_t> answer;    ///< the cheapest that meets the budget
    std::optional<std::size_t> runner_up; ///< the cheapest that meets it another way
    std::optional<std::size_t> nearest;   ///< where none meets it: least excess, of equal ones the cheapest
};

/// All by figures and their margin (Margin::sure). Depends on the set of trials alone, not on their order. The answer breaks no limit; a
/// looser budget never makes it dearer.
Choice choose(std::span<const Trial> trials, const Budget& budget);

} // namespace reliefbake

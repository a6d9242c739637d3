#pragma once
// Measures what a choice needs, cheapest first, and no more.

#include "cli/advise/advice_plan.h"
#include "cli/advise/choose.h"

#include <functional>
#include <vector>

namespace reliefbake {

/// Who measures. Figures of bytes are those of the whole map in both.
struct Measurers {
    std::function<Result<Measurement>(const Candidate&)> screen; ///< a quick look: on part of the map, by fewer rays
    std::function<Result<Measurement>(const Candidate&)> prove;  ///< on the whole map, by other rays than the screen's
};

struct Advice {
    struct Measured {
        const Method* method;
        bool proven;
    };
    std::vector<Trial> trials;      ///< in the order measured
    std::vector<Measured> measured; ///< of each trial
    Choice choice;                  ///< indices of trials that were proven
    struct Probed {
        StoredSurface surface;
        bool proven;
        Measurement figures; ///< of probe_of
        bool given_up;
    };
    std::vector<Probed> surfaces;
    std::vector<const Way*> given_up; ///< of surfaces given up before any march
    std::vector<const Way*> untried;  ///< dearer than what was chosen, and not measured

    std::size_t count(bool proven) const;
};

/// A candidate is near the budget whose screened figures break no limit by more than this factor: a crop is not the map.
constexpr double screen_slack = 1.5;

/// A surface is given up where an exact march over it breaks a limit by more than this factor, unless it is the finest.
constexpr double surface_slack = 2;

/// Goes through the ways in order of bytes, all of equal bytes at a time. Of each surface an exact march is measured first, in the
/// screen and before the first proof: what the surface loses no technique brings back. Of each way the longest march is screened first,
/// and shorter ones as long as the last is near the budget; those near it are proven in order of cost. Ends when two ways are proven
/// to meet the budget. Where none is, the three nearest are proven, too, before it says so.
/// Guarantee: the answer meets the budget by figures of `prove` and their margin. Deterministic. Errors: those of the measurers.
Result<Advice> search_advice(const std::vector<Way>& ways, const Budget& budget, const Measurers& measurers);

} // namespace reliefbake

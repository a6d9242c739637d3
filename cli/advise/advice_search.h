#pragma once
// Measures what a choice needs, cheapest first, and no more.

#include "cli/advise/advice_plan.h"
#include "cli/advise/choose.h"

#include <functional>
#include <vector>

namespace reliefbake {

/// Who measures. Figures of bytes are those of the whole map in both.
struct Measurers {
    std::function<Result<Measurement>(const Candidate&)> on_crop; ///< none: the whole is small, and measured at once
    std::function<Result<Measurement>(const Candidate&)> on_whole;
};

struct Advice {
    struct Measured {
        const Method* method;
        bool whole;
    };
    std::vector<Trial> trials;      ///< in the order measured
    std::vector<Measured> measured; ///< of each trial
    Choice choice;                  ///< indices of trials; all are of the whole
    struct Probed {
        StoredSurface surface;
        bool whole;
        Measurement figures; ///< of probe_of
        bool given_up;
    };
    std::vector<Probed> surfaces;
    std::vector<const Way*> given_up; ///< of those surfaces
    std::vector<const Way*> untried;  ///< dearer than what was chosen, and not measured

    std::size_t count(bool whole) const;
};

/// A candidate whose figures on the crop break no limit by more than this factor is measured on the whole: a crop is not the map.
constexpr double crop_slack = 1.5;

/// A surface is given up where an exact march over it breaks a limit by more than this factor, unless it is the finest.
constexpr double surface_slack = 2;

/// Goes through the ways in order of bytes, all of equal bytes at a time. Of each surface an exact march is measured first: what the surface
/// loses no technique brings back. Of each way the longest march is measured first, on the crop,
/// and shorter ones as long as the last is near the budget; those near it are measured on the whole, in order of cost. Ends when two
/// ways meet the budget on the whole. Where none does, the three nearest on the crop are measured on the whole before it says so.
/// Guarantee: the answer meets the budget by figures of the whole. Deterministic. Errors: those of the measurers.
Result<Advice> search_advice(const std::vector<Way>& ways, const Budget& budget, const Measurers& measurers);

} // namespace reliefbake

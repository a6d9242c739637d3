#pragma once
// What a map may cost and how wrong it may be, and what a measurement says to that.

#include "cli/tradeoff/judge.h"

#include <limits>
#include <string>
#include <vector>

namespace reliefbake {

struct Budget {
    double max_missed = 0;    ///< share of rays that may be missed, 0 to 1 (--max-missed)
    double max_error = 0.01;  ///< mean height error, parts of the depth, above 0 up to 1 (--max-error)
    int steps = 128;          ///< most rounds of any ray, those that refine included, 1 or more (--steps)
    double bytes_per_texel = std::numeric_limits<double>::infinity(); ///< of all channels, for a texel of the source (--bytes-per-texel)
};

/// One limit of a budget that is broken.
struct Fault {
    enum class Limit { rays, missed, error, steps, bytes };
    Limit limit;
    double found, sure, allowed; ///< sure: found, and its margin of sampling; rays: how many there were, and one
    double excess;               ///< sure / allowed; of missed rays as if two were allowed at least
};

/// By how many standard deviations of their sampling the share missed and the mean error must stay within their limits.
enum class Margin {
    none, ///< as found: of a look that is not the last word
    sure, ///< 3.3: then another measurement by as many rays stays within, too, with 99 % (2.33 for each of the two, whose variances add)
};

/// All limits that the figures break; a figure that is no number breaks its limit, and figures of no ray prove nothing. Where no ray is
/// missed there is no margin: no number of rays would show a share of exactly 0.
std::vector<Fault> faults_of(const Measurement& figures, const Budget& budget, Margin margin);

inline bool meets(const Measurement& figures, const Budget& budget) { return faults_of(figures, budget, Margin::sure).empty(); }

/// Largest excess of a fault, at least 1.
double excess_of(const Measurement& figures, const Budget& budget, Margin margin);

/// E.g. "missed 3.1 % > 1 %", or "missed 0.98 % (1.1 % by other rays) > 1 %".
std::string text_of(const Fault& fault);

} // namespace reliefbake

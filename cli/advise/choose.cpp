#include "cli/advise/choose.h"

#include <limits>
#include <tuple>

namespace reliefbake {
namespace {

double counted(double instructions) { return instructions > 0 ? instructions : std::numeric_limits<double>::infinity(); }

} // namespace

bool is_cheaper(const Trial& a, const Trial& b) {
    const auto cost = [](const Trial& trial) {
        const Measurement& f = trial.figures;
        return std::tuple(f.bytes_per_texel, f.fetches_mean, counted(f.instructions), f.error_mean, id_of(trial.candidate));
    };
    return cost(a) < cost(b);
}

bool is_same_way(const Candidate& a, const Candidate& b) {
    return a.map == b.map && a.march.technique == b.march.technique && a.march.exact_finish == b.march.exact_finish;
}

Choice choose(std::span<const Trial> trials, const Budget& budget) {
    Choice choice;
    const auto keep_cheaper = [&](std::optional<std::size_t>& best, std::size_t k) {
        if (!best || is_cheaper(trials[k], trials[*best])) best = k;
    };
    for (std::size_t k = 0; k < trials.size(); ++k)
        if (meets(trials[k].figures, budget)) keep_cheaper(choice.answer, k);
    if (choice.answer) {
        for (std::size_t k = 0; k < trials.size(); ++k)
            if (meets(trials[k].figures, budget) && !is_same_way(trials[k].candidate, trials[*choice.answer].candidate)) keep_cheaper(choice.runner_up, k);
        return choice;
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < trials.size(); ++k) {
        const double excess = excess_of(trials[k].figures, budget, Margin::sure);
        if (excess < least) choice.nearest.reset(), least = excess;
        if (excess == least) keep_cheaper(choice.nearest, k);
    }
    return choice;
}

} // namespace reliefbake

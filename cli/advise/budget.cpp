#include "cli/advise/budget.h"

#include "cli/report/format_text.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double few_rays = 2; ///< by so many one measurement may differ from another
constexpr double endless = std::numeric_limits<double>::infinity();

void check(std::vector<Fault>& faults, Fault::Limit limit, double found, double allowed, double least) {
    if (found <= allowed) return;
    const double excess = found / std::max(allowed, least);
    faults.push_back({limit, found, allowed, std::isnan(excess) ? endless : excess});
}

} // namespace

std::vector<Fault> faults_of(const Measurement& figures, const Budget& budget) {
    std::vector<Fault> faults;
    if (figures.rays == 0) return {{Fault::Limit::rays, 0, 1, endless}};
    check(faults, Fault::Limit::missed, figures.missed, budget.max_missed, few_rays / double(figures.rays));
    check(faults, Fault::Limit::error, figures.error_mean, budget.max_error, 0);
    check(faults, Fault::Limit::steps, figures.steps_max, budget.steps, 0);
    check(faults, Fault::Limit::bytes, figures.bytes_per_texel, budget.bytes_per_texel, 0);
    return faults;
}

double excess_of(const Measurement& figures, const Budget& budget) {
    double excess = 1;
    for (const Fault& fault : faults_of(figures, budget)) excess = std::max(excess, fault.excess);
    return excess;
}

std::string text_of(const Fault& fault) {
    switch (fault.limit) {
    case Fault::Limit::rays:
        return "no ray meets it";
    case Fault::Limit::missed:
        return format("missed %.2g %% > %.2g %%", 100 * fault.found, 100 * fault.allowed);
    case Fault::Limit::error:
        return format("mean error %.2g > %.2g", fault.found, fault.allowed);
    case Fault::Limit::steps:
        return format("%.0f steps > %.0f", fault.found, fault.allowed);
    case Fault::Limit::bytes:
        return format("%.3g bytes a texel > %.3g", fault.found, fault.allowed);
    }
    return "";
}

} // namespace reliefbake

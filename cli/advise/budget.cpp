#include "cli/advise/budget.h"

#include "cli/report/format_text.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double sure_deviations = 3.3;
constexpr double few_rays = 2; ///< by so many one measurement may differ from another
constexpr double endless = std::numeric_limits<double>::infinity();

void check(std::vector<Fault>& faults, Fault::Limit limit, double found, double margin, double allowed, double least = 0) {
    const double sure = found + margin;
    if (sure <= allowed) return;
    const double excess = sure / std::max(allowed, least);
    faults.push_back({limit, found, sure, allowed, std::isnan(excess) ? endless : excess});
}

std::string found_text(const Fault& fault, const char* number, double unit) {
    const std::string found = format(number, unit * fault.found);
    return fault.found > fault.allowed || std::isnan(fault.found) ? found : found + " (" + format(number, unit * fault.sure) + " by other rays)";
}

} // namespace

std::vector<Fault> faults_of(const Measurement& figures, const Budget& budget, Margin margin) {
    std::vector<Fault> faults;
    if (figures.rays == 0) return {{Fault::Limit::rays, 0, 0, 1, endless}};
    const double rays = double(figures.rays), deviations = margin == Margin::sure ? sure_deviations : 0;
    check(faults, Fault::Limit::missed, figures.missed, deviations * std::sqrt(figures.missed * (1 - figures.missed) / rays), budget.max_missed, few_rays / rays);
    check(faults, Fault::Limit::error, figures.error_mean, deviations * figures.error_deviation / std::sqrt(rays), budget.max_error);
    check(faults, Fault::Limit::steps, figures.steps_max, 0, budget.steps);
    check(faults, Fault::Limit::bytes, figures.bytes_per_texel, 0, budget.bytes_per_texel);
    return faults;
}

double excess_of(const Measurement& figures, const Budget& budget, Margin margin) {
    double excess = 1;
    for (const Fault& fault : faults_of(figures, budget, margin)) excess = std::max(excess, fault.excess);
    return excess;
}

std::string text_of(const Fault& fault) {
    switch (fault.limit) {
    case Fault::Limit::rays:
        return "no ray meets it";
    case Fault::Limit::missed:
        return "missed " + found_text(fault, "%.2g %%", 100) + format(" > %.2g %%", 100 * fault.allowed);
    case Fault::Limit::error:
        return "mean error " + found_text(fault, "%.2g", 1) + format(" > %.2g", fault.allowed);
    case Fault::Limit::steps:
        return format("%.0f steps > %.0f", fault.found, fault.allowed);
    case Fault::Limit::bytes:
        return format("%.3g bytes a texel > %.3g", fault.found, fault.allowed);
    }
    return "";
}

} // namespace reliefbake

#include "cli/advise/advice_report.h"

#include "cli/advise/bake_command_text.h"
#include "cli/choices.h"
#include "cli/report/format_text.h"
#include "cli/tradeoff/measurement_json.h"
#include "cli/version.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

using nlohmann::json;

std::string share(double part) { return part == 0 ? "0" : format("%.2g %%", 100 * part); }

std::string cost_text(const Measurement& f) {
    return format("%.3g bytes a texel, %.3g texture reads", f.bytes_per_texel, f.fetches_mean) + (f.instructions > 0 ? format(" and %.0f instructions a ray", f.instructions) : " a ray");
}

std::string surface_text(const StoredSurface& surface) {
    const std::string bits = word_of(bits_words, surface.bits);
    return (is_unorm(surface.bits) ? bits + " bits" : bits) + (surface.level > 0 ? " at 1/" + std::to_string(1 << surface.level) : " at full size");
}

Margin margin_of(const AdviceReport& report, std::size_t trial) { return report.advice.measured[trial].proven ? Margin::sure : Margin::none; }

std::vector<Fault> faults_of(const AdviceReport& report, std::size_t trial) { return faults_of(report.advice.trials[trial].figures, report.budget, margin_of(report, trial)); }

std::string faults_text(const AdviceReport& report, std::size_t trial) {
    std::string text;
    for (const Fault& fault : faults_of(report, trial)) text += (text.empty() ? "" : ", ") + text_of(fault);
    return text;
}

json faults_json(const AdviceReport& report, std::size_t trial) {
    json faults = json::array();
    for (const Fault& fault : faults_of(report, trial)) faults.push_back(text_of(fault));
    return faults;
}

json budget_json(const AdviceReport& report) {
    const Budget& budget = report.budget;
    json bytes; // null: no limit
    if (std::isfinite(budget.bytes_per_texel)) bytes = budget.bytes_per_texel;
    return {{"max_missed", budget.max_missed}, {"max_error", budget.max_error}, {"steps", budget.steps}, {"bytes_per_texel", bytes}, {"angle", report.judge.steepest}};
}

json chosen_json(const AdviceReport& report, const std::optional<std::size_t>& index) {
    if (!index) return nullptr;
    const Trial& trial = report.advice.trials[*index];
    return {{"id", id_of(trial.candidate)}, {"trial", *index}, {"method", report.advice.measured[*index].method->word}, {"bake", bake_command_text(trial.candidate.map)}, {"march", march_text(trial.candidate.march)}};
}

/// The least excess among a method's trials, proven where it got there.
std::optional<std::size_t> best_of(const AdviceReport& report, const Method& method) {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < report.advice.trials.size(); ++k) {
        const Advice::Measured& measured = report.advice.measured[k];
        if (measured.method != &method) continue;
        const auto rank = [&](std::size_t place) { return excess_of(report.advice.trials[place].figures, report.budget, margin_of(report, place)); };
        const bool farther = best && (measured.proven == report.advice.measured[*best].proven ? rank(k) >= rank(*best) : !measured.proven);
        if (!farther) best = k;
    }
    return best;
}

double fewest_bytes(const std::vector<const Way*>& ways, const Method& method) {
    for (const Way* way : ways) // in order of bytes
        if (way->method == &method) return way->bytes_per_texel;
    return 0;
}

/// What of a method was never marched, and why.
std::vector<std::string> left_out(const AdviceReport& report, const Method& method) {
    std::vector<std::string> reasons;
    std::string lost;
    for (const Advice::Probed& probed : report.advice.surfaces) {
        const auto on_it = [&](const Way& way) { return way.method == &method && surface_of(way.marches.front()) == probed.surface; };
        if (probed.given_up && std::any_of(report.plan.ways.begin(), report.plan.ways.end(), on_it)) lost += (lost.empty() ? "" : ", ") + surface_text(probed.surface);
    }
    if (!lost.empty()) reasons.push_back("given up with its surface: " + lost);
    if (const double bytes = fewest_bytes(report.advice.untried, method); bytes > 0) reasons.push_back(format("dearer and not measured from %.3g bytes a texel on", bytes));
    std::vector<const Way*> too_large;
    for (const Way& way : report.plan.too_large) too_large.push_back(&way);
    if (const double bytes = fewest_bytes(too_large, method); bytes > 0) reasons.push_back(format("over the budget from %.3g bytes a texel on", bytes));
    return reasons;
}

bool is_given_up(const AdviceReport& report, const StoredSurface& surface) {
    return std::any_of(report.advice.surfaces.begin(), report.advice.surfaces.end(), [&](const Advice::Probed& probed) { return probed.given_up && probed.surface == surface; });
}

/// Why a method is neither the answer nor the runner-up.
std::string why_not(const AdviceReport& report, const Method& method) {
    if (report.budget.max_missed == 0 && !misses_none(method.base)) return "left out: nothing promises that it misses no ray";
    std::vector<std::string> reasons = left_out(report, method);
    if (const std::optional<std::size_t> best = best_of(report, method)) {
        const Trial& trial = report.advice.trials[*best];
        const std::string faults = faults_text(report, *best), where = report.advice.measured[*best].proven ? "" : ", screened";
        if (faults.empty() && !is_given_up(report, surface_of(trial.candidate))) return "meets it" + where + ", dearer: " + cost_text(trial.figures);
        reasons.insert(reasons.begin(), (faults.empty() ? "meets it" : faults) + where + ": " + id_of(trial.candidate));
    }
    std::string text;
    for (const std::string& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
    return text.empty() ? "left out: the steps, the target or the output do not allow it" : text;
}

std::string surfaces_text(const AdviceReport& report) {
    std::string text;
    for (const Advice::Probed& probed : report.advice.surfaces) {
        if (!probed.given_up) continue;
        text += "given up  " + surface_text(probed.surface) + ": an exact march" + (probed.proven ? "" : ", screened,") + " misses " + share(probed.figures.missed) + format(", mean error %.2g\n", probed.figures.error_mean);
    }
    return text;
}

std::string chosen_text(const AdviceReport& report, const char* title, std::size_t index) {
    const Trial& trial = report.advice.trials[index];
    const Measurement& f = trial.figures;
    std::string text = format("%-10s", title) + std::string(report.advice.measured[index].method->title) + ", " + cost_text(f) + "\n";
    text += "  bake    reliefbake " + bake_command_text(trial.candidate.map) + "\n";
    text += "  follow  " + march_text(trial.candidate.march) + "\n";
    text += "  proven  missed " + share(f.missed) + ", early " + share(f.early) + format(", mean error %.2g, %.0f steps at most, of %llu rays\n", f.error_mean, f.steps_max, static_cast<unsigned long long>(f.rays));
    return text;
}

std::string counts_text(const AdviceReport& report) {
    std::size_t candidates = 0, untried = 0;
    for (const Way& way : report.plan.ways) candidates += way.marches.size();
    for (const Way* way : report.advice.untried) untried += way->marches.size();
    std::string text = "measured  " + std::to_string(report.advice.count(false)) + " of " + std::to_string(candidates) + " candidates screened";
    if (report.crop > 0) text += format(" on a crop of %d x %d", report.crop, report.crop);
    return text + ", " + std::to_string(report.advice.count(true)) + " proven on the whole; " + std::to_string(untried) + " are dearer than the runner-up\n";
}

} // namespace

const char* word_of_target(ShaderTarget target) {
    switch (target) {
    case ShaderTarget::glsl: return "glsl";
    case ShaderTarget::glsl_es: return "glsl-es";
    case ShaderTarget::hlsl: return "hlsl";
    }
    return "";
}

json advice_json(const AdviceReport& report) {
    json trials = json::array();
    for (std::size_t k = 0; k < report.advice.trials.size(); ++k) {
        const Trial& trial = report.advice.trials[k];
        trials.push_back({{"method", report.advice.measured[k].method->word}, {"stage", report.advice.measured[k].proven ? "proof" : "screen"}, {"candidate", to_json(trial.candidate)},
                          {"figures", to_json(trial.figures)}, {"faults", faults_json(report, k)}});
    }
    json surfaces = json::array();
    for (const Advice::Probed& probed : report.advice.surfaces)
        surfaces.push_back({{"bits", word_of(bits_words, probed.surface.bits)}, {"resolution", std::ldexp(1.0, -probed.surface.level)}, {"stage", probed.proven ? "proof" : "screen"},
                            {"missed", probed.figures.missed}, {"error_mean", probed.figures.error_mean}, {"given_up", probed.given_up}});
    std::size_t candidates = 0;
    for (const Way& way : report.plan.ways) candidates += way.marches.size();
    json crop, applied; // null: none
    if (report.crop > 0) crop = report.crop;
    if (!report.applied.empty()) applied = report.applied;
    const Choice& choice = report.advice.choice;
    return {{"version", version()}, {"input", report.input}, {"width", report.width}, {"height", report.height}, {"depth_scale", report.depth_scale}, {"target", word_of_target(report.target)},
            {"budget", budget_json(report)}, {"missed_depth", report.judge.missed_depth}, {"crop", crop}, {"rays", {{"screen", report.screen_rays}, {"proof", report.judge.rays}}}, {"met", choice.answer.has_value()}, {"answer", chosen_json(report, choice.answer)},
            {"runner_up", chosen_json(report, choice.runner_up)}, {"nearest", chosen_json(report, choice.nearest)}, {"candidates", candidates}, {"surfaces", surfaces}, {"trials", trials}, {"applied", applied}};
}

std::string nearest_text(const AdviceReport& report) {
    if (report.plan.ways.empty()) {
        if (report.plan.too_large.empty()) return report.input + ": the budget cannot be met: no candidate fits the steps, the target and the output";
        const Way& least = report.plan.too_large.front();
        return report.input + format(": the budget of %.3g bytes a texel cannot be met; the nearest is %.3g, ", report.budget.bytes_per_texel, least.bytes_per_texel) + id_of(least.marches.front().map);
    }
    const Trial& trial = report.advice.trials[*report.advice.choice.nearest];
    return report.input + ": the budget cannot be met by any of " + std::to_string(report.advice.trials.size()) + " measurements; the nearest is " + id_of(trial.candidate) + ": " + faults_text(report, *report.advice.choice.nearest);
}

std::string advice_text(const AdviceReport& report) {
    const Choice& choice = report.advice.choice;
    std::string text;
    if (choice.answer) text += chosen_text(report, "take", *choice.answer);
    if (choice.runner_up) text += chosen_text(report, "runner-up", *choice.runner_up);
    else if (choice.answer) text += "runner-up none: nothing else meets the budget\n";
    if (choice.nearest) text += chosen_text(report, "nearest", *choice.nearest);
    text += counts_text(report);
    const auto is_chosen = [&](const Method& method) {
        for (const std::optional<std::size_t>& index : {choice.answer, choice.runner_up, choice.nearest})
            if (index && report.advice.measured[*index].method == &method) return true;
        return false;
    };
    text += surfaces_text(report) + "the others:\n";
    for (const Method& method : all_methods())
        if (method.by_default && !is_chosen(method)) text += format("  %-13s ", std::string(method.word).c_str()) + why_not(report, method) + "\n";
    if (!report.applied.empty()) text += "baked     " + report.applied + ", read back and judged again: the same figures\n";
    return text;
}

} // namespace reliefbake

#include "cli/stress/stress_report.h"

#include "cli/choices.h"
#include "cli/report/format_text.h"
#include "cli/report/svg_plot.h"

#include <algorithm>

namespace reliefbake {
namespace {

constexpr double least_kept_drawn = 0.05, least_dead_drawn = 1e-4; ///< less is drawn on the axis

double share(std::uint64_t part, std::uint64_t all) { return all > 0 ? double(part) / double(all) : 0; }

nlohmann::json rays_json(const Comparison& rays) {
    return {{"rays", rays.rays}, {"violated", rays.missed}, {"early", share(rays.early, rays.rays)}, {"out_of_steps", share(rays.out_of_steps, rays.rays)},
            {"steps_mean", rays.steps_mean}, {"steps_max", rays.steps_max}, {"tolerance", rays.tolerance_max}};
}

nlohmann::json exact_json(const ExactCheck& exact) {
    return {{"points", exact.points}, {"violated", exact.violated}, {"undecided", exact.undecided}, {"doubles_wrong", exact.doubles_wrong}, {"doubles_above", exact.doubles_above}};
}

using Value = double (*)(const Usefulness&);

/// A curve for each encoding and bit depth that `differs` somewhere from what floats give.
std::string curves(const std::vector<Usefulness>& measured, LogPlot plot, Value value, bool (*differs)(double)) {
    plot.x_label = "slope of the relief around a texel: 1 / mean cone, heights of the relief per texture width";
    for (const auto& [bits_word, bits] : bits_words)
        for (const auto& [encoding_word, encoding] : encoding_words) {
            PlotSeries series{encoding_word + ", " + bits_word, {}};
            bool drawn = false;
            for (const Usefulness& at : measured) {
                if (at.encoding != encoding || at.bits != bits) continue;
                series.points.push_back({at.slope(), value(at)});
                drawn = drawn || differs(value(at));
            }
            if (drawn) plot.series.push_back(std::move(series));
        }
    return svg_text(plot);
}

} // namespace

nlohmann::json to_json(const StressResult& r) {
    return {{"case", r.field}, {"width", r.grid.width}, {"height", r.grid.height}, {"pixel_aspect", r.grid.pixel_aspect}, {"depth_scale", r.depth_scale},
            {"wrap", r.grid.wrap_x == Wrap::repeat ? "repeat" : "clamp"}, {"encoding", word_of(encoding_words, r.encoding)}, {"bits", word_of(bits_words, r.bits)},
            {"holds", r.holds()}, {"judge", r.exact ? "rationals" : "doubles"}, {"levels", r.levels}, {"ratio_mean", r.ratio_mean}, {"tightness", r.tightness},
            {"dead", r.dead}, {"dead_share", share(r.dead, std::uint64_t(r.grid.width) * std::uint64_t(r.grid.height))},
            {"doubles", {{"points", r.cones.points}, {"violated", r.cones.violations}, {"worst", r.cones.worst}}},
            {"exact", r.exact ? exact_json(*r.exact) : nlohmann::json()}, {"rays", r.rays ? rays_json(*r.rays) : nlohmann::json()}};
}

nlohmann::json usefulness_json(const std::vector<Usefulness>& measured) {
    nlohmann::json encodings = nlohmann::json::array(), useful = nlohmann::json::array();
    for (const Usefulness& at : measured)
        encodings.push_back({{"width", at.width}, {"encoding", word_of(encoding_words, at.encoding)}, {"bits", word_of(bits_words, at.bits)},
                             {"slope", at.slope()}, {"dead_share", at.dead}, {"kept", at.kept}});
    for (const auto& [bits_word, bits] : bits_words)
        for (const auto& [encoding_word, encoding] : encoding_words)
            useful.push_back({{"encoding", encoding_word}, {"bits", bits_word}, {"slope", useful_slope(measured, encoding, bits)}});
    return {{"encodings", encodings}, {"useful", useful}};
}

std::string stress_heading() {
    return format("%-30s %5s  %-19s %-19s %-15s %9s %6s %7s %5s\n", "case", "bakes", "rays violated / of", "points violated / of", "exact", "tightness", "dead", "steps", "most");
}

std::string stress_line(const std::string& name, const std::vector<StressResult>& cases) {
    std::uint64_t rays = 0, missed = 0, points = 0, violated = 0, exact = 0, broken = 0;
    double tightness = INFINITY, dead = 0, steps = 0, most = 0;
    for (const StressResult& r : cases) {
        points += r.cones.points, violated += r.cones.violations;
        if (r.exact) exact += r.exact->points, broken += r.exact->violated + r.exact->undecided;
        if (r.rays) rays += r.rays->rays, missed += r.rays->missed, steps = std::max(steps, r.rays->steps_mean), most = std::max(most, r.rays->steps_max);
        tightness = std::min(tightness, r.tightness);
        dead = std::max(dead, share(r.dead, std::uint64_t(r.grid.width) * std::uint64_t(r.grid.height)));
    }
    const auto of = [](std::uint64_t part, std::uint64_t all) { return all > 0 ? std::to_string(part) + " / " + std::to_string(all) : std::string("-"); };
    return format("%-30s %5zu  %-19s %-20s %-14s %9.3f %4.0f %% %7.1f %5.0f\n", name.c_str(), cases.size(), of(missed, rays).c_str(), of(violated, points).c_str(),
                  of(broken, exact).c_str(), tightness, 100 * dead, steps, most);
}

std::string usefulness_text(const std::vector<Usefulness>& measured) {
    std::string text = format("\nUseful up to a slope of (heights of the relief per texture width; at least %g of a cone kept, at most %g %% of texels dead):\n%-8s", Usefulness::least_kept,
                              100 * Usefulness::most_dead, "");
    for (const auto& [bits_word, bits] : bits_words) text += format("%9s", bits_word.c_str());
    for (const auto& [encoding_word, encoding] : encoding_words) {
        text += format("\n%-8s", encoding_word.c_str());
        for (const auto& [bits_word, bits] : bits_words) text += format("%9.0f", useful_slope(measured, encoding, bits));
    }
    return text + "\n";
}

std::string kept_svg(const std::vector<Usefulness>& measured) {
    const LogPlot plot{"What is left of a cone (not drawn: all others keep 0.9 and more)", "", "decoded cone / baked cone, mean", {}, {}, {}, least_kept_drawn};
    return curves(measured, plot, [](const Usefulness& at) { return at.kept; }, [](double kept) { return kept < 0.9; });
}

std::string dead_svg(const std::vector<Usefulness>& measured) {
    const LogPlot plot{"Dead texels (not drawn: all others have none)", "", "share of texels whose cone is code 0", {}, {}, {}, least_dead_drawn};
    return curves(measured, plot, [](const Usefulness& at) { return at.dead; }, [](double dead) { return dead > 0; });
}

} // namespace reliefbake

#include "cli/tradeoff/tradeoff_report.h"

#include "cli/report/format_text.h"
#include "cli/report/html_page.h"
#include "cli/report/svg_plot.h"
#include "cli/tradeoff/pareto.h"
#include "cli/version.h"

#include <algorithm>
#include <set>

namespace reliefbake {
namespace {

constexpr TradeoffCost costs[] = {
    {"steps", "steps of a ray, mean", &Measurement::steps_mean, true},
    {"fetches", "texture fetches of a ray, mean", &Measurement::fetches_mean, true},
    {"instructions", "instructions of a ray, mean (SPIR-V)", &Measurement::instructions, true},
    {"time", "processor time of a frame, ms", &Measurement::cpu_ms_per_frame, true},
    {"bytes", "bytes of a source texel", &Measurement::bytes_per_texel, false},
};

/// Names of a candidate's axes, in the order of columns.
constexpr const char* axis_names[] = {"id", "kind", "planes", "family", "encoding", "bits", "tolerance", "cone_max", "resolution", "technique", "exact_finish", "steps", "refinements"};

std::string csv_cell(const nlohmann::json& value) {
    if (value.is_null()) return "";
    if (value.is_number()) return digits(value.get<double>());
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    return value.get<std::string>();
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string safe = "\"";
    for (const char c : text) safe += c == '"' ? std::string("\"\"") : std::string(1, c);
    return safe + "\"";
}

std::string percent(double share) { return share == 0 ? "0" : format("%.3g %%", 100 * share); }

/// What a person calls a candidate: the method and what is not at the usual.
std::string described(const MeasuredCandidate& point) {
    const Candidate& candidate = point.planned.candidate;
    const nlohmann::json axes = to_json(candidate);
    std::string text = std::string(point.planned.method->title) + ", " + std::to_string(candidate.march.steps) + " steps";
    if (!axes["refinements"].is_null()) text += " + " + csv_cell(axes["refinements"]);
    text += "; " + csv_cell(axes["bits"]) + (is_unorm(candidate.map.bits) ? " bits" : "");
    if (!axes["encoding"].is_null()) text += " " + csv_cell(axes["encoding"]);
    if (candidate.map.level > 0) text += ", resolution " + csv_cell(axes["resolution"]);
    if (candidate.map.has_cones() && candidate.map.cone.tolerance != ConeOptions().tolerance) text += ", tolerance " + csv_cell(axes["tolerance"]);
    return text;
}

std::vector<std::string> front_row(const MeasuredCandidate& point, const PngPair& pictures) {
    const Measurement& m = point.figures;
    const std::string name = described(point);
    return {escaped(name), html_picture(pictures.colour, name), html_picture(pictures.error, "error of " + name),
            format("%.1f", m.steps_mean), format("%.1f", m.fetches_mean), format("%.0f", m.instructions), format("%.2f", m.bytes_per_texel),
            format("%.2f", m.cpu_ms_per_frame), format("%.2g", m.bake_seconds), percent(m.missed), percent(m.early), format("%.2g", m.error_mean),
            format("%.2g", m.error_p99), format("%.2g", m.mse), format("%.3g", m.dissimilarity)};
}

const std::vector<std::string> front_heads = {"candidate", "picture", "error", "steps", "fetches", "instructions", "bytes a source texel", "CPU ms a frame", "bake, s",
                                              "missed", "early", "mean error", "99 % error", "mse", "1 - SSIM"};

std::string introduction(const JudgeOptions& options, double depth_scale) {
    std::string text = "<p>reliefbake " + escaped(version()) + ". Every point is a map, baked in memory, and a march over it, judged by exact intersections with the source's own surface, so that fewer bits and "
                       "coarser maps are errors too. About " + std::to_string(options.rays) + " rays in seven views from above to " + digits(options.steepest) +
                       " degrees, depth " + digits(depth_scale) + " texture widths. ";
    text += "Missed: rays that went on beyond the first hit by more than " + format("%.4g", options.missed_depth) + " of the depth; early: that stopped before it. Mean error: how much lower or higher a ray "
            "ends than the exact hit, in parts of the depth. 1 - SSIM: how different the shaded picture looks.</p>\n<p>Steps, fetches, instructions and bytes are the same on every machine; times are of ";
    return text + (options.backend == RendererBackend::osmesa ? "Mesa's software rasteriser" : "the device behind EGL") +
           " and of this machine. Error pictures: dark 1e-5 of the depth and less, yellow all of it.</p>\n";
}

} // namespace

std::span<const TradeoffCost> tradeoff_costs() { return costs; }

std::vector<std::size_t> front_of(const TradeoffSection& section, const TradeoffCost& cost) {
    std::vector<CostAndError> points;
    std::vector<std::size_t> index;
    for (std::size_t k = 0; k < section.candidates.size(); ++k) {
        const Measurement& figures = section.candidates[k].figures;
        if (figures.*cost.value > 0) points.push_back({figures.*cost.value, figures.error_mean}), index.push_back(k); // 0: not known
    }
    std::vector<std::size_t> front = pareto_front(points);
    for (std::size_t& k : front) k = index[k];
    return front;
}

std::string tradeoff_csv(const std::vector<TradeoffSection>& sections) {
    std::string text = "input,method,base";
    for (const char* name : axis_names) text.append(",").append(name);
    for (const MeasurementField& field : measurement_fields()) text.append(",").append(field.name);
    text += ",rays\n";
    for (const TradeoffSection& section : sections)
        for (const MeasuredCandidate& point : section.candidates) {
            text += quoted(section.file).append(",").append(point.planned.method->word).append(point.planned.base ? ",yes" : ",no");
            const nlohmann::json axes = to_json(point.planned.candidate);
            for (const char* name : axis_names) text.append(",").append(csv_cell(axes[name]));
            for (const MeasurementField& field : measurement_fields()) text.append(",").append(digits(point.figures.*field.value));
            text.append(",").append(std::to_string(point.figures.rays)).append("\n");
        }
    return text;
}

nlohmann::json tradeoff_json(const std::vector<TradeoffSection>& sections, const JudgeOptions& options, double depth_scale) {
    nlohmann::json inputs = nlohmann::json::array(), views = nlohmann::json::array();
    for (const JudgeView& view : judge_views(options.steepest)) views.push_back({{"angle", view.angle}, {"azimuth", view.azimuth}});
    for (const TradeoffSection& section : sections) {
        nlohmann::json points = nlohmann::json::array(), fronts = nlohmann::json::object();
        for (const MeasuredCandidate& point : section.candidates)
            points.push_back({{"method", point.planned.method->word}, {"base", point.planned.base}, {"candidate", to_json(point.planned.candidate)}, {"figures", to_json(point.figures)}});
        for (const TradeoffCost& cost : costs) {
            fronts[cost.word] = nlohmann::json::array();
            for (const std::size_t k : front_of(section, cost)) fronts[cost.word].push_back(id_of(section.candidates[k].planned.candidate));
        }
        inputs.push_back({{"input", section.file}, {"width", section.width}, {"height", section.height}, {"pictures", section.pictures}, {"measurements", std::move(points)}, {"fronts", std::move(fronts)}});
    }
    return {{"version", version()}, {"renderer", options.backend == RendererBackend::osmesa ? "osmesa" : "egl"}, {"depth_scale", depth_scale},
            {"missed_depth", options.missed_depth}, {"views", views}, {"inputs", inputs}};
}

std::string tradeoff_svg(const TradeoffSection& section, const TradeoffCost& cost) {
    LogPlot plot;
    plot.title = section.name, plot.x_label = cost.title, plot.y_label = "mean height error, parts of the depth";
    for (const Method& method : all_methods()) {
        PlotSeries series{std::string(method.title), {}};
        for (const MeasuredCandidate& point : section.candidates)
            if (point.planned.base && point.planned.method == &method && point.figures.*cost.value > 0) series.points.emplace_back(point.figures.*cost.value, point.figures.error_mean);
        if (!series.points.empty()) plot.series.push_back(std::move(series));
    }
    for (const MeasuredCandidate& point : section.candidates)
        if (!point.planned.base) plot.dots.emplace_back(point.figures.*cost.value, point.figures.error_mean);
    for (const std::size_t k : front_of(section, cost)) plot.front.emplace_back(section.candidates[k].figures.*cost.value, section.candidates[k].figures.error_mean);
    return svg_text(plot);
}

std::string tradeoff_html(const std::vector<TradeoffSection>& sections, const JudgeOptions& options, double depth_scale, const PicturesOf& pictures_of) {
    std::string body = "<h1>Speed against accuracy</h1>\n" + introduction(options, depth_scale);
    for (const TradeoffSection& section : sections) {
        body += "<h2>" + escaped(section.file) + ", " + std::to_string(section.width) + " x " + std::to_string(section.height) + "</h2>\n";
        std::set<std::size_t> shown;
        for (const TradeoffCost& cost : costs) {
            if (cost.plotted) body += tradeoff_svg(section, cost);
            const std::vector<std::size_t> front = front_of(section, cost);
            shown.insert(front.begin(), front.end());
            body += "<p>Pareto front, " + escaped(cost.title) + ": ";
            for (std::size_t k = 0; k < front.size(); ++k) body += (k > 0 ? " &#8594; " : "") + escaped(described(section.candidates[front[k]]));
            body += "</p>\n";
        }
        std::vector<std::size_t> order(shown.begin(), shown.end());
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return section.candidates[a].figures.error_mean > section.candidates[b].figures.error_mean; });
        std::vector<std::vector<std::string>> rows;
        for (const std::size_t k : order) rows.push_back(front_row(section.candidates[k], pictures_of(section, id_of(section.candidates[k].planned.candidate))));
        body += "<h3>Every point of the fronts</h3>\n" + html_table(front_heads, rows);
    }
    return html_page("Speed against accuracy", body);
}

} // namespace reliefbake

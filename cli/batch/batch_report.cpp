#include "cli/batch/batch_report.h"

#include "cli/report/format_text.h"
#include "cli/report/html_page.h"
#include "cli/report/svg_plot.h"
#include "cli/version.h"

#include <algorithm>
#include <system_error>

namespace reliefbake {

namespace {

std::string percent(const std::optional<double>& share) { return !share ? "" : *share == 0 ? "0" : format("%.2g %%", 100 * *share); }

std::string statistics_text(const nlohmann::json& statistics) {
    std::string text;
    for (const auto& [key, value] : statistics.items())
        if (value.is_number()) text += (text.empty() ? "" : ", ") + escaped(key) + " " + format("%.4g", value.get<double>());
    return text;
}

std::string summary_markup(const BatchSummary& summary) {
    std::string text = format("<p>reliefbake %s, %s: %zu assets: %zu baked, %zu from the cache, %zu unchanged, %zu failed, %zu not started; %zu files left out; %.3g s with %d at once.</p>\n", escaped(version()).c_str(),
                              escaped(summary.state).c_str(), summary.assets, summary.baked, summary.from_cache, summary.unchanged, summary.failures.size(), summary.not_started(), summary.skipped_files,
                              summary.seconds, summary.jobs);
    if (!summary.stopped_by.empty()) text += "<p>Stopped: " + escaped(summary.stopped_by) + "</p>\n";
    for (const std::string& note : summary.notes) text += "<p>" + escaped(note) + "</p>\n";
    return text;
}

std::string failure_table(const BatchSummary& summary) {
    if (summary.failures.empty()) return "";
    std::vector<std::vector<std::string>> rows;
    for (const AssetFailure& failure : summary.failures)
        rows.push_back({escaped(failure.source), escaped(failure.id), std::to_string(int(failure.error.code)), escaped(failure.error.message), failure.before ? "before" : "now"});
    return "<h2>Failures</h2>\n" + html_table({"source", "asset", "exit code", "reason", "met"}, rows);
}

std::vector<std::string> asset_row(const ReportedAsset& asset) {
    const LedgerLine& line = *asset.line;
    std::string warnings;
    for (const std::string& warning : line.warnings) warnings += (warnings.empty() ? "" : "<br/>") + escaped(warning);
    return {escaped(line.id), asset.check.thumbnail.empty() ? "" : html_picture(asset.check.thumbnail, line.id), escaped(line.kind), escaped(asset.check.verdict), percent(asset.check.missed),
            percent(asset.check.early), format("%.3g", line.seconds), statistics_text(line.statistics), warnings};
}

} // namespace

std::string batch_html(const BatchSummary& summary, std::vector<ReportedAsset> assets) {
    std::stable_sort(assets.begin(), assets.end(), [](const ReportedAsset& a, const ReportedAsset& b) {
        return a.check.severity != b.check.severity ? a.check.severity > b.check.severity : a.line->id < b.line->id;
    });
    std::vector<std::vector<std::string>> rows;
    for (const ReportedAsset& asset : assets) rows.push_back(asset_row(asset));
    return html_page("Batch", "<h1>Batch</h1>\n" + summary_markup(summary) + failure_table(summary) +
                                  "<h2>Assets, worst first</h2>\n<p>Judged by some 7000 rays from 45 and 70 degrees and 2000 points each, bump maps by their values: missed rays went through relief; early ones stopped before it, for want of steps at the most. Seconds: times threads, of the bake.</p>\n" +
                                  html_table({"asset", "", "kind", "verdict", "missed", "early", "bake, s", "statistics", "warnings"}, rows));
}

std::string report_batch(const BatchPlan& plan, const LedgerLines& lines, const BatchSummary& summary, int threads) {
    std::vector<ReportedAsset> assets;
    AssetChecker checker(threads);
    for (const BatchJob& job : plan.jobs) {
        const auto line = lines.find(job.id);
        if (line == lines.end() || line->second.failure) continue;
        assets.push_back({&line->second, checker.check(plan.out, line->second)});
    }
    return batch_html(summary, std::move(assets));
}

} // namespace reliefbake

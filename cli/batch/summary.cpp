#include "cli/batch/summary.h"

#include "cli/report/format_text.h"
#include "cli/version.h"

#include <algorithm>

namespace reliefbake {

std::size_t BatchSummary::failed_before() const {
    return std::size_t(std::count_if(failures.begin(), failures.end(), [](const AssetFailure& failure) { return failure.before; }));
}

nlohmann::json to_json(const BatchSummary& s) {
    nlohmann::json failures = nlohmann::json::array();
    for (const AssetFailure& failure : s.failures)
        failures.push_back({{"id", failure.id}, {"source", failure.source}, {"code", int(failure.error.code)}, {"reason", failure.error.message}, {"before", failure.before}});
    return {{"version", version()},       {"state", s.state},         {"stopped_by", s.stopped_by}, {"assets", s.assets},
            {"baked", s.baked},           {"from_cache", s.from_cache}, {"unchanged", s.unchanged},   {"failed", s.failures.size()},
            {"failed_before", s.failed_before()}, {"not_started", s.not_started()}, {"skipped_files", s.skipped_files}, {"seconds", s.seconds},
            {"jobs", s.jobs},             {"threads", s.threads},     {"memory", s.memory},         {"notes", s.notes},
            {"failures", std::move(failures)}};
}

Result<BatchSummary> summary_from(const nlohmann::json& json) try {
    BatchSummary s;
    json.at("state").get_to(s.state), json.at("stopped_by").get_to(s.stopped_by);
    json.at("assets").get_to(s.assets), json.at("baked").get_to(s.baked), json.at("from_cache").get_to(s.from_cache), json.at("unchanged").get_to(s.unchanged);
    json.at("skipped_files").get_to(s.skipped_files), json.at("seconds").get_to(s.seconds);
    json.at("jobs").get_to(s.jobs), json.at("threads").get_to(s.threads), json.at("memory").get_to(s.memory), json.at("notes").get_to(s.notes);
    for (const nlohmann::json& failure : json.at("failures"))
        s.failures.push_back({failure.at("id"), failure.at("source"), Error{ErrorCode(failure.at("code").get<int>()), failure.at("reason")}, failure.at("before")});
    return s;
} catch (const nlohmann::json::exception&) {
    return fail(ErrorCode::bad_data, "is no summary of a batch");
}

std::string summary_text(const BatchSummary& s) {
    std::string text = format("%zu assets: %zu baked, %zu from the cache, %zu unchanged, %zu failed (%zu of them before), %zu not started; %.3g s\n", s.assets, s.baked,
                              s.from_cache, s.unchanged, s.failures.size(), s.failed_before(), s.not_started(), s.seconds);
    for (const std::string& note : s.notes) text += "  note: " + note + "\n";
    return text;
}

} // namespace reliefbake

#include "cli/tradeoff/sweep.h"

namespace reliefbake {

Result<SweepRecord> SweepRecord::open(const std::string& folder) {
    const std::string path = folder + "/measurements.jsonl";
    Result<RecordFile> file = RecordFile::open(path);
    if (!file) return tl::unexpected(file.error());
    SweepRecord record(std::move(*file));
    std::size_t number = 0;
    for (const std::string& line : record.file_.lines()) {
        ++number;
        const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
        std::optional<Measurement> figures;
        if (json.is_object() && json.contains("key") && json["key"].is_string() && json.contains("figures")) figures = measurement_from_json(json["figures"]);
        if (!figures) return fail(ErrorCode::bad_data, path + ": line " + std::to_string(number) + " is no measurement of this version; remove the file, or choose another folder");
        record.known_[json["key"].get<std::string>()] = *figures;
    }
    return record;
}

const Measurement* SweepRecord::find(const std::string& key) const {
    const auto found = known_.find(key);
    return found == known_.end() ? nullptr : &found->second;
}

Result<void> SweepRecord::add(const std::string& key, const Candidate& candidate, const Measurement& measurement) {
    known_[key] = measurement;
    return file_.append(nlohmann::json{{"key", key}, {"id", id_of(candidate)}, {"figures", to_json(measurement)}}.dump());
}

Result<SweepResult> run_sweep(const std::vector<PlannedCandidate>& planned, SweepRecord& record,
                              const std::function<std::string(const std::string& id)>& key_of,
                              const std::function<Result<Measurement>(const Candidate&)>& measure) {
    SweepResult result;
    for (const PlannedCandidate& next : planned) {
        const std::string key = key_of(id_of(next.candidate));
        if (const Measurement* known = record.find(key)) {
            result.candidates.push_back({next, *known});
            continue;
        }
        const Result<Measurement> figures = measure(next.candidate);
        if (!figures) return tl::unexpected(figures.error());
        if (Result<void> kept = record.add(key, next.candidate, *figures); !kept) return tl::unexpected(kept.error());
        result.candidates.push_back({next, *figures});
        ++result.measured_anew;
    }
    return result;
}

} // namespace reliefbake

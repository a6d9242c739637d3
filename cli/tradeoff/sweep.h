#pragma once
// A sweep: measures what its record does not hold yet.

#include "cli/tradeoff/measurement_json.h"
#include "cli/tradeoff/sweep_plan.h"
#include "formats/record_file.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace reliefbake {

/// Finished measurements by the hash of all that decides them.
class SweepRecord {
  public:
    /// Opens FOLDER/measurements.jsonl. Errors: those of RecordFile::open; bad_data (a line that is none of its own).
    static Result<SweepRecord> open(const std::string& folder);

    const Measurement* find(const std::string& key) const;
    /// On the disk when it returns. Errors: write_failed.
    Result<void> add(const std::string& key, const Candidate& candidate, const Measurement& measurement);

  private:
    explicit SweepRecord(RecordFile file) : file_(std::move(file)) {}
    RecordFile file_;
    std::map<std::string, Measurement> known_;
};

struct MeasuredCandidate {
    PlannedCandidate planned;
    Measurement figures;
};

struct SweepResult {
    std::vector<MeasuredCandidate> candidates;
    std::size_t measured_anew = 0;
};

/// `key_of`: of a candidate's id. `measure` is called, in order, for what the record lacks. Errors: those of both.
Result<SweepResult> run_sweep(const std::vector<PlannedCandidate>& planned, SweepRecord& record,
                              const std::function<std::string(const std::string& id)>& key_of,
                              const std::function<Result<Measurement>(const Candidate&)>& measure);

} // namespace reliefbake

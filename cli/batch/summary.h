#pragma once
// What became of a batch.

#include "bake/error.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbake {

struct AssetFailure {
    std::string id, source;
    Error error;
    bool before = false; ///< in an earlier run; nothing has changed since
};

struct BatchSummary {
    std::string state = "finished"; ///< "finished", "stopped" (--fail-fast, a full disk), "interrupted"
    std::string stopped_by;         ///< why it is not "finished"
    std::size_t assets = 0, baked = 0, from_cache = 0, unchanged = 0, skipped_files = 0;
    std::vector<AssetFailure> failures;
    double seconds = 0;
    int jobs = 0, threads = 0;
    std::uint64_t memory = 0;
    std::vector<std::string> notes; ///< what was found odd and mended: temporaries of a killed run, a cache that cannot be written

    std::size_t failed_before() const;
    std::size_t not_started() const { return assets - baked - from_cache - unchanged - failures.size(); }
};

/// As cli/schema/batch_summary.schema.json has it.
nlohmann::json to_json(const BatchSummary& summary);

/// What to_json made. Errors: bad_data.
Result<BatchSummary> summary_from(const nlohmann::json& json);

/// For people: counts, and a line for each failure.
std::string summary_text(const BatchSummary& summary);

} // namespace reliefbake

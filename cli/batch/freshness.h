#pragma once
// Whether an asset has to be baked, and why.

#include "bake/error.h"
#include "cli/batch/batch_plan.h"
#include "cli/batch/ledger.h"

#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// What is true of a job's inputs: their stamps, taken before their bytes were hashed, and what they decode to.
struct InputIdentity {
    std::vector<FileRecord> files; ///< in the order of BatchJob::inputs
    std::string decoded;
};

/// Errors: no_input.
Result<std::vector<FileRecord>> identify_inputs(const BatchJob& job);

/// Hash of the decoded inputs, or of the bytes of those that are no images or cannot be decoded, which the bake will tell.
std::string decoded_hash(const BatchJob& job, const std::vector<FileRecord>& inputs);

struct Freshness {
    bool must_bake = true;
    std::string reason;               ///< "new", "its options changed", ...; of a fresh asset empty
    bool failed_before = false;       ///< fresh: it was refused, and nothing has changed since
    std::optional<LedgerLine> renewed; ///< fresh, with other stamps: touched, moved, or written anew with what decodes alike
};

/// Compares an asset with its line (null: there is none). Files whose stamps are as they were are not read.
Freshness judge(const BatchJob& job, const LedgerLine* line, const std::filesystem::path& out, bool retry_failed);

} // namespace reliefbake

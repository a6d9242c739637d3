#pragma once
// One asset from its input to its line in the ledger.

#include "cli/batch/bake_cache.h"
#include "cli/batch/batch_plan.h"
#include "cli/batch/ledger.h"

#include <optional>

namespace reliefbake {

struct AssetResult {
    LedgerLine line;            ///< with its outputs, or its failure
    std::optional<Error> error; ///< why it failed
    bool lasting = false;       ///< the failure is one that the same input and options would meet again: it goes into the ledger
    bool from_cache = false;
    std::string cache_fault;    ///< why the cache could not keep it; the asset is well
};

/// Identifies the inputs, takes the outputs out of the cache (if any) or bakes them, and hashes what was written.
/// Threads and memory are what it may use: a cone map whose format takes rows (exr, tif) is baked out of core rather than use more.
AssetResult bake_asset(const BatchJob& job, const std::filesystem::path& out, int threads, std::uint64_t memory, const BakeCache* cache);

} // namespace reliefbake

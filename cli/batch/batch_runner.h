#pragma once
// Assets baked at once: files side by side first, threads within a file where few are left.

#include "cli/batch/bake_asset.h"
#include "cli/batch/batch_reporter.h"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbake {

struct AssetToBake {
    const BatchJob* job;
    std::string reason;
};

struct RunLimits {
    int jobs = 1;             ///< assets at once
    int threads = 1;          ///< of all of them together
    std::uint64_t memory = 0; ///< bytes that the assets at work may be predicted to need together
    bool fail_fast = false;
};

/// Bakes all, the costliest first, and records each in the ledger. An asset gets the share of the threads that it is of the work left,
/// at least one. It waits until its predicted memory fits; one that never will is baked out of core, alone, where its
/// command and format can, else it fails (budget). After a
/// failure (with fail_fast), or when a disk is full, no more are started. What is written does not depend on any of the limits.
/// Errors: write_failed (a full disk, or the ledger).
Result<void> run_assets(const std::vector<AssetToBake>& assets, const std::filesystem::path& out, const RunLimits& limits, const BakeCache* cache, Ledger& ledger,
                        BatchReporter& reporter);

} // namespace reliefbake

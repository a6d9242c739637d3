#pragma once
// The ledgers of a batch's shards, put into one.

#include "bake/error.h"
#include "cli/batch/summary.h"

#include <filesystem>

namespace reliefbake {

/// After all shards of OUT have run to their end: OUT/.reliefbake has one ledger and one summary, as one run would have left them, and
/// no shards; nothing is baked. Errors: no_input (no shards; one of N has not run to its end: names it), busy (one is at work),
/// bad_data (a summary that cannot be read), cannot_create, write_failed.
Result<BatchSummary> merge_shards(const std::filesystem::path& out);

} // namespace reliefbake

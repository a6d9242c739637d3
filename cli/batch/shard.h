#pragma once
// A batch divided among machines that share its folders.

#include "bake/error.h"
#include "cli/batch/batch_plan.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

struct Shard {
    int index = 0; ///< from 0
    int count = 1;
};

constexpr int most_shards = 100000;

/// `given`: --shard "I/N", or empty: then `count` (--shards, 0 without) and who runs this say it: SLURM_ARRAY_TASK_ID, less the array's least
/// index, of SLURM_ARRAY_TASK_COUNT, or JOB_COMPLETION_INDEX (Kubernetes). Errors: usage (none of these, or numbers that do not fit each other).
Result<Shard> find_shard(const std::string& given, int count);

/// The shard of each job: the costliest first, each to the shard that has least so far, by predictions from headers and options alone. All shards of one plan
/// find the same.
std::vector<int> assign_shards(const std::vector<BatchJob>& jobs, int count);

/// Leaves the jobs of one shard.
void keep_shard(BatchPlan& plan, const Shard& shard);

/// What a shard keeps, below the state folder of the whole batch: "shards/I-of-N".
std::filesystem::path shard_folder(const std::filesystem::path& state, const Shard& shard);

/// The shard whose folder is called NAME.
std::optional<Shard> shard_of_folder(const std::string& name);

} // namespace reliefbake

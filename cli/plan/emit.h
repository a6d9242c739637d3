#pragma once
// A batch as work for other runners.

#include "bake/error.h"
#include "cli/batch/batch_plan.h"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbake {

/// Whoever runs what is emitted.
struct EmitOptions {
    std::string program;                 ///< the tool
    std::filesystem::path folder;        ///< that relative names are meant from
    int shards = 0;                      ///< slurm, k8s
    std::vector<std::string> batch;      ///< slurm, k8s: the options of `run`
    std::string image, claim;            ///< k8s: the container, and the persistent volume that holds `folder`
};

/// One line a job for a POSIX shell, which makes the folder it needs: for xargs or GNU parallel. Errors: usage (a name with a line break).
Result<std::string> emit_commands(const BatchPlan& plan, const EmitOptions& options);

/// A build.ninja: each job's first output depends on all of its inputs; equal bytes keep their time. Errors: usage (a name with a line break).
Result<std::string> emit_ninja(const BatchPlan& plan, const EmitOptions& options);

/// A script for sbatch: an array of `run`, a task a shard.
Result<std::string> emit_slurm(const EmitOptions& options);

/// A manifest for kubectl (JSON): an indexed job of `run`.
Result<std::string> emit_k8s(const EmitOptions& options);

/// A word as a POSIX shell must read it to get `text`.
std::string shell_quoted(const std::string& text);

} // namespace reliefbake

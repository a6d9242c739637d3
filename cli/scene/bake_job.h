#pragma once
// A planned run over one source as the command that makes it, given its options one by one: no path is ever quoted or split.

#include "cli/cone/stored_height.h"
#include "cli/scene/scene_plan.h"

namespace reliefbake {

/// Decodes and checks the source of a job of cone maps. Errors: those of read_source.
Result<BakeSource> read_job_source(const SceneJob& job);

/// Plans every command of the job as it will run, for files of `prefix` + their name, which nothing is written to. Errors: those of the commands.
Result<void> check_job(const SceneJob& job, const std::string& prefix);

/// Bakes the job's maps to `prefix` + their name; those of one run appear together. Warnings go to stderr. `threads`: resolved.
/// Errors: those of the commands.
Result<void> bake_job(const SceneJob& job, const std::string& prefix, int threads);

} // namespace reliefbake

#pragma once
// Where a plan's files go, checked before the first one is written.

#include "cli/scene/scene_plan.h"

namespace reliefbake {

/// Refuses files that two maps would write, also where only the case of their letters differs; files that the scene reads or names, of
/// any asset (usage); places where no file can be written (cannot_create).
Result<void> check_outputs(const Scene& scene, const ScenePlan& plan, const std::string& folder);

/// Plans every run of the plan as it will be, without its folder, which need not exist yet. Errors: those of the commands.
Result<void> check_jobs(const ScenePlan& plan, const std::string& folder);

/// Creates the folder, and those above it. Errors: cannot_create.
Result<void> make_output_folder(const std::string& folder);

} // namespace reliefbake

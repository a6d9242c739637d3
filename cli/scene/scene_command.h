#pragma once
// reliefbake scene SCENE -o DIR: the maps that a scene needs, and no others.

#include "cli/command.h"
#include "cli/scene/scene_plan.h"

namespace reliefbake {

class SceneCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    std::string file_;   ///< SCENE
    std::string folder_; ///< -o
    bool dry_run_ = false, json_ = false, quiet_ = false;
    int threads_ = 0;
};

/// A scene that nothing can refuse any more but the disk.
struct PreparedScene {
    Scene scene;
    std::vector<AssetFacts> facts;
    ScenePlan plan, everything;
};

/// Reads, surveys, plans and checks; writes nothing. `threads`: resolved.
/// Errors: those of read_scene, survey_scene, plan_scene, check_outputs and check_jobs.
Result<PreparedScene> prepare_scene(const std::string& file, const std::string& folder, int threads);

/// Bakes every job to `folder`, which exists; the seconds of each. Errors: those of bake_job; files of jobs before it stay.
Result<std::vector<double>> bake_jobs(const ScenePlan& plan, const std::string& folder, int threads);

} // namespace reliefbake

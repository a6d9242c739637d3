#include "cli/scene/scene_command.h"

#include "cli/options/thread_option.h"
#include "cli/scene/bake_job.h"
#include "cli/scene/read_scene.h"
#include "cli/scene/scene_outputs.h"
#include "cli/scene/scene_report.h"
#include "cli/scene/survey.h"
#include "cli/stage_clock.h"

#include <chrono>
#include <cstdio>

namespace reliefbake {

Result<PreparedScene> prepare_scene(const std::string& file, const std::string& folder, int threads) {
    Result<Scene> scene = read_scene(file);
    if (!scene) return tl::unexpected(scene.error());
    Result<std::vector<AssetFacts>> facts = survey_scene(*scene, threads);
    if (!facts) return tl::unexpected(facts.error());
    Result<ScenePlan> plan = plan_scene(*scene, *facts);
    if (!plan) return tl::unexpected(plan.error());
    ScenePlan everything = plan_everything(*scene, *facts);
    return check_outputs(*scene, *plan, folder)
        .and_then([&] { return check_jobs(*plan, folder); })
        .and_then([&] { return check_jobs(everything, folder); }) // sources that nothing is baked from, too
        .map([&] { return PreparedScene{std::move(*scene), std::move(*facts), std::move(*plan), std::move(everything)}; });
}

Result<std::vector<double>> bake_jobs(const ScenePlan& plan, const std::string& folder, int threads) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> seconds;
    for (const SceneJob& job : plan.jobs) {
        const auto start = Clock::now();
        if (Result<void> baked = bake_job(job, folder + "/", threads); !baked) return tl::unexpected(baked.error());
        seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
    return seconds;
}

void SceneCommand::add_to(CLI::App& app) {
    app.add_option("SCENE", file_, "Scene: a .toml of [[asset]] tables, or a .gltf or .glb whose materials have extras.reliefbake (docs/SCENE.md)")->required();
    app.add_option("-o,--output", folder_, "Folder for the maps; made if there is none")->required()->type_name("DIR");
    app.add_flag("--dry-run", dry_run_, "Plan, measure and check everything, say what would be written, and write nothing");
    CLI::Option* json = app.add_flag("--json", json_, "Print one result object (cli/schema/scene.schema.json)");
    app.add_flag("--quiet", quiet_, "Print nothing unless something is wrong")->excludes(json);
    add_thread_option(app, threads_);
}

Result<void> SceneCommand::run() {
    if (folder_.empty()) return fail(ErrorCode::usage, "-o: expected a folder, found none");
    const Result<int> threads = resolve_threads(threads_);
    if (!threads) return tl::unexpected(threads.error());
    ProgressLine progress(!quiet_);
    progress.set_stage("planning");
    const Result<PreparedScene> prepared = prepare_scene(file_, folder_, *threads);
    if (!prepared) return tl::unexpected(prepared.error());
    SceneRun run{prepared->scene, prepared->facts, prepared->plan, prepared->everything, folder_, {}};
    if (!dry_run_) {
        if (Result<void> made = make_output_folder(folder_); !made) return made;
        progress.set_stage("baking");
        Result<std::vector<double>> seconds = bake_jobs(prepared->plan, folder_, *threads);
        if (!seconds) return tl::unexpected(seconds.error());
        run.seconds = std::move(*seconds);
    }
    progress.stop();
    if (quiet_) return {};
    // A file's name need not be UTF-8; JSON must be.
    const std::string text = json_ ? scene_json(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n" : scene_summary(run);
    std::fputs(text.c_str(), stdout);
    return {};
}

} // namespace reliefbake

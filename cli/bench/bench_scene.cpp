#include "cli/bench/bench_scene.h"

#include "cli/options/thread_option.h"
#include "cli/report/format_text.h"
#include "cli/scene/bake_cost.h"
#include "cli/scene/scene_command.h"
#include "cli/scene/scene_outputs.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <numeric>

namespace reliefbake {
namespace {

/// Each map in a run of its own, so that its time is its own.
ScenePlan apart(const ScenePlan& plan) {
    ScenePlan maps;
    for (const SceneJob& job : plan.jobs)
        for (const SceneMap& map : job.maps) maps.jobs.push_back({job.input, job.source_options, {map}});
    return maps;
}

struct Cost {
    double seconds = 0;
    std::uint64_t units = 0;
};

std::uint64_t file_bytes(const ScenePlan& plan, const std::string& folder) {
    std::uint64_t bytes = 0;
    for (const SceneJob& job : plan.jobs)
        for (const SceneMap& map : job.maps)
            for (const SceneFile& file : map.files) {
                std::error_code ignored;
                bytes += std::filesystem::file_size(folder + "/" + file.name, ignored);
            }
    return bytes;
}

struct Baked {
    double seconds;
    std::uint64_t file_bytes;
};

Result<Baked> bake_in(const ScenePlan& plan, const std::string& folder, int threads) {
    if (Result<void> made = make_output_folder(folder); !made) return tl::unexpected(made.error());
    const Result<std::vector<double>> seconds = bake_jobs(plan, folder, threads);
    if (!seconds) return tl::unexpected(seconds.error());
    return Baked{std::accumulate(seconds->begin(), seconds->end(), 0.0), file_bytes(plan, folder)};
}

} // namespace

void BenchSceneCommand::add_to(CLI::App& app) {
    app.add_option("SCENE", file_, "Scene, as for `reliefbake scene`")->required();
    app.add_option("-o,--output", folder_, "Folder for needed/, everything/ and single/: each kind of map in a run of its own")->required()->type_name("DIR");
    add_thread_option(app, threads_);
}

Result<void> BenchSceneCommand::run() {
    const Result<int> threads = resolve_threads(threads_);
    if (!threads) return tl::unexpected(threads.error());
    const Result<PreparedScene> prepared = prepare_scene(file_, folder_ + "/needed", *threads);
    if (!prepared) return tl::unexpected(prepared.error());
    if (Result<void> apart_from_inputs = check_outputs(prepared->scene, prepared->everything, folder_ + "/everything"); !apart_from_inputs) return apart_from_inputs;
    const Result<Baked> needed = bake_in(prepared->plan, folder_ + "/needed", *threads);
    if (!needed) return tl::unexpected(needed.error());
    const Result<Baked> everything = bake_in(prepared->everything, folder_ + "/everything", *threads);
    if (!everything) return tl::unexpected(everything.error());

    // Kinds of maps, those of both plans.
    std::map<std::string, Cost> costs;
    if (Result<void> made = make_output_folder(folder_ + "/single"); !made) return made;
    for (const ScenePlan* plan : {&prepared->everything, &prepared->plan}) {
        const ScenePlan single = apart(*plan);
        const Result<std::vector<double>> seconds = bake_jobs(single, folder_ + "/single", *threads);
        if (!seconds) return tl::unexpected(seconds.error());
        for (std::size_t k = 0; k < single.jobs.size(); ++k) {
            const SceneMap& map = single.jobs[k].maps.front();
            costs[map.what].seconds += (*seconds)[k], costs[map.what].units += map.units;
        }
    }
    const auto nanoseconds = [](const Cost& cost) { return cost.units > 0 ? 1e9 * cost.seconds / double(cost.units) : 0.0; };
    for (const auto& [what, cost] : costs)
        std::fputs(format("%-18s %8.0f ns a %s; predictions take %.0f\n", what.c_str(), nanoseconds(cost), what == "quadrics" ? "vertex" : "texel", nanoseconds_of(what)).c_str(), stdout);
    const auto line = [](const char* name, const Baked& baked, const ScenePlan& plan) {
        std::fputs(format("%-10s %.3g s (predicted %.3g s), %llu bytes of texels and vertices, %llu of files\n", name, baked.seconds, plan.predicted_seconds(), static_cast<unsigned long long>(plan.bytes()), static_cast<unsigned long long>(baked.file_bytes)).c_str(), stdout);
    };
    line("needed", *needed, prepared->plan);
    line("everything", *everything, prepared->everything);
    return {};
}

} // namespace reliefbake

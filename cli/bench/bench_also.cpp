#include "cli/bench/bench_also.h"

#include "cli/cone/bake_command.h"
#include "cli/cone/bake_maps.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone at the end.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name = (fs::temp_directory_path() / "reliefbake-bench-XXXXXX").string();
        if (mkdtemp(name.data())) path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// Seconds of a run, and of its stages over all maps.
struct Times {
    double total = std::numeric_limits<double>::infinity();
    std::map<std::string, double> stages;
};

/// Bakes; keeps the times if it was faster than before.
Result<void> time_run(const std::vector<std::vector<ConePlan>>& runs, Times& best) {
    Times now;
    const auto start = std::chrono::steady_clock::now();
    for (const std::vector<ConePlan>& plans : runs) {
        const Result<BakedMaps> baked = bake_maps(plans);
        if (!baked) return tl::unexpected(baked.error());
        for (const BakedMap& map : baked->maps)
            for (const auto& [stage, seconds] : map.seconds) now.stages[stage] += seconds;
    }
    now.total = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    now.stages.erase("total");
    if (now.total < best.total) best = now;
    return {};
}

} // namespace

void BenchAlsoCommand::add_to(CLI::App& app) {
    maps_ = {"cone", "cone --encoding ratio", "cone-normal", "cone --kind relaxed", "acm", "acm --kind relaxed", "cone-stack --levels 3"};
    add_run_options(app, options_);
    app.option_defaults()->group("Measurement");
    app.add_option("--map", maps_, "A map to bake, as in --also but without its output; repeatable (default: seven of all families)")
        ->type_name("'COMMAND OPTIONS'")
        ->allow_extra_args(false);
    app.add_option("--repeat", repeat_, "Runs of each kind, in turn; the fastest counts (default 5)")->check(CLI::Range(1, 1000));
}

Result<void> BenchAlsoCommand::run() {
    const bool json = options_.json;
    options_.json = false, options_.quiet = true;
    const ScratchFolder folder;
    if (folder.path().empty()) return fail(ErrorCode::cannot_create, std::string("cannot create a folder for temporary files"));
    std::vector<ConePlan> together;
    std::vector<std::vector<ConePlan>> apart;
    for (std::size_t k = 0; k < maps_.size(); ++k) {
        const fs::path output = folder.path() / ("map" + std::to_string(k) + ".png");
        const Result<ConeCommandOptions> given = parse_also(maps_[k] + " -o '" + output.string() + "'", options_);
        if (!given) return tl::unexpected(given.error());
        const Result<ConePlan> plan = plan_cone(*given);
        if (!plan) return tl::unexpected(plan.error());
        together.push_back(*plan);
        apart.push_back({*plan});
    }
    Times times_apart, times_together;
    for (int k = 0; k < repeat_; ++k) {
        if (Result<void> done = time_run(apart, times_apart); !done) return done;
        if (Result<void> done = time_run({together}, times_together); !done) return done;
    }
    const double saved = 1 - times_together.total / times_apart.total;
    if (json) {
        const nlohmann::json result = {{"maps", maps_},
                                       {"threads", together[0].cone.threads},
                                       {"apart_seconds", times_apart.total},
                                       {"together_seconds", times_together.total},
                                       {"saved", saved},
                                       {"apart_stages", times_apart.stages},
                                       {"together_stages", times_together.stages}};
        std::printf("%s\n", result.dump(2).c_str());
        return {};
    }
    std::printf("%zu maps of %s, %d threads, ms     apart  together\n", maps_.size(), options_.input.c_str(), together[0].cone.threads);
    for (const auto& [stage, seconds] : times_apart.stages)
        std::printf("    %-20s %10.1f %9.1f\n", stage.c_str(), 1000 * seconds, 1000 * times_together.stages[stage]);
    std::printf("    %-20s %10.1f %9.1f: %.0f %% saved\n", "all", 1000 * times_apart.total, 1000 * times_together.total, 100 * saved);
    return {};
}

} // namespace reliefbake

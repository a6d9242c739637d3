#include "cli/scene/bake_job.h"

#include "cli/bump/bake_bump.h"
#include "cli/cone/bake_families.h"
#include "cli/cone/bake_maps.h"
#include "cli/quadric/bake_quadric.h"
#include "cli/quadric/quadric_options.h"
#include "cli/shape/bake_shape.h"
#include "cli/shape/shape_options.h"

#include <algorithm>
#include <cstdio>

namespace reliefbake {
namespace {

using Arguments = std::vector<std::string>;

/// A path that no command takes for an option.
std::string as_operand(const std::string& path) { return path.starts_with('-') ? "./" + path : path; }

Result<void> parse(CLI::App& app, Arguments words) {
    std::reverse(words.begin(), words.end()); // as CLI11 wants them
    try {
        app.parse(words);
    } catch (const CLI::ParseError& error) {
        return fail(ErrorCode::usage, error.what());
    }
    return {};
}

Arguments run_words(const SceneJob& job) {
    Arguments words = {as_operand(job.input)};
    words.insert(words.end(), job.source_options.begin(), job.source_options.end());
    return words;
}

Arguments own_words(const SceneMap& map, const std::string& prefix) {
    Arguments words = map.options;
    words.insert(words.end(), {"-o", as_operand(prefix + map.output)});
    return words;
}

Arguments all_words(const SceneJob& job, const std::string& prefix) {
    Arguments words = run_words(job);
    const Arguments own = own_words(job.maps.front(), prefix);
    words.insert(words.end(), own.begin(), own.end());
    return words;
}

bool is_cone_job(const SceneJob& job) { return make_bake_command(job.maps.front().command) != nullptr; }

/// The plan of each map; the first takes the options of the run, as --also has it.
Result<std::vector<ConePlan>> cone_plans(const SceneJob& job, const std::string& prefix, int threads) {
    std::vector<ConePlan> plans;
    ConeCommandOptions run;
    for (std::size_t k = 0; k < job.maps.size(); ++k) {
        const std::unique_ptr<BakeCommand> command = make_bake_command(job.maps[k].command);
        CLI::App app;
        if (k == 0) command->add_to(app);
        else command->add_own_options(app);
        if (Result<void> parsed = parse(app, k == 0 ? all_words(job, prefix) : own_words(job.maps[k], prefix)); !parsed) return tl::unexpected(parsed.error());
        Result<ConeCommandOptions> given = command->given();
        if (!given) return tl::unexpected(given.error());
        given->cone.threads = threads, given->quiet = true;
        if (k == 0) run = *given;
        else copy_run_options(run, *given);
        Result<ConePlan> plan = plan_cone(*given);
        if (!plan) return tl::unexpected(plan.error());
        plans.push_back(std::move(*plan));
    }
    if (Result<void> apart = validate_outputs(plans); !apart) return tl::unexpected(apart.error());
    return plans;
}

Result<void> bake_cones(const SceneJob& job, const std::string& prefix, int threads) {
    const Result<std::vector<ConePlan>> plans = cone_plans(job, prefix, threads);
    if (!plans) return tl::unexpected(plans.error());
    const Result<BakedMaps> baked = bake_maps(*plans);
    if (!baked) return tl::unexpected(baked.error());
    for (const BakedMap& map : baked->maps)
        for (const std::string& warning : map.warnings) std::fprintf(stderr, "reliefbake scene: warning: %s\n", warning.c_str());
    return {};
}

/// Runs the command as its command line would.
template <class T>
Result<void> run_as(Arguments words, int threads) {
    words.insert(words.end(), {"--threads", std::to_string(threads), "--quiet"});
    T command;
    CLI::App app;
    command.add_to(app);
    return parse(app, std::move(words)).and_then([&] { return command.run(); });
}

/// Parses `words` by `add` and hands the options to `plan`.
template <class Options, class Add, class Plan>
Result<void> plan_as(const Arguments& words, Add add, Plan plan) {
    CLI::App app;
    Options options;
    add(app, options);
    if (Result<void> parsed = parse(app, words); !parsed) return parsed;
    return plan(options).map([](const auto&) {});
}

} // namespace

Result<BakeSource> read_job_source(const SceneJob& job) {
    ConeCommandOptions options;
    CLI::App app;
    add_run_options(app, options);
    if (Result<void> parsed = parse(app, run_words(job)); !parsed) return fail(parsed.error().code, job.input + ": " + parsed.error().message);
    StageClock clock(false);
    return read_source(options, clock);
}

Result<void> check_job(const SceneJob& job, const std::string& prefix) {
    const std::string& command = job.maps.front().command;
    const Arguments words = all_words(job, prefix);
    if (is_cone_job(job)) return cone_plans(job, prefix, 1).map([](const auto&) {});
    if (command == "bump") return plan_as<BumpCommandOptions>(words, add_bump_options, plan_bump);
    if (command == "shape") return plan_as<ShapeCommandOptions>(words, add_shape_options, plan_shape);
    return plan_as<QuadricCommandOptions>(words, add_quadric_options, plan_quadric);
}

Result<void> bake_job(const SceneJob& job, const std::string& prefix, int threads) {
    const std::string& command = job.maps.front().command;
    const Arguments words = all_words(job, prefix);
    if (is_cone_job(job)) return bake_cones(job, prefix, threads);
    if (command == "bump") return run_as<BumpCommand>(words, threads);
    if (command == "shape") return run_as<ShapeCommand>(words, threads);
    return run_as<QuadricCommand>(words, threads);
}

} // namespace reliefbake

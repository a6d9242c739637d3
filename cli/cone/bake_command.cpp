#include "cli/cone/bake_command.h"

#include "cli/cone/bake_maps.h"
#include "cli/command_output.h"
#include "cli/cone/cone_report.h"
#include "cli/cone/large/bake_bands.h"
#include "cli/cone/plan_files.h"

#include <algorithm>

namespace reliefbake {

namespace {

std::string start_of(const std::string& also) { return "--also '" + also + "': "; }

/// Why a word that the command does not know cannot stand in --also.
std::string why_not(const std::string& word) {
    if (word.empty() || word[0] != '-') return "expected options, found '" + word + "'; IN is the run's";
    const std::string name = word.substr(0, word.find('='));
    CLI::App run;
    ConeCommandOptions ignored;
    add_run_options(run, ignored);
    if (run.get_option_no_throw(name) || name == "--also") return name + ": is one for all maps of a run; give it outside of --also";
    return "no such option: " + name;
}

void print(const BakedMaps& baked, const std::optional<LargeReport>& large = std::nullopt) {
    std::vector<ConeRun> runs;
    for (const BakedMap& map : baked.maps)
        runs.push_back({map.plan, baked.source.image, baked.source.report, map.info, map.grid, map.warnings, map.seconds, map.levels, large});
    for (const ConeRun& run : runs)
        for (const std::string& warning : run.warnings) print_warning(run.plan.given.command, warning);
    const ConeCommandOptions& given = baked.maps.front().plan.given;
    if (given.quiet) return;
    if (given.json) {
        print_result(cone_result_text(runs));
        return;
    }
    for (const ConeRun& run : runs) print_result(cone_summary(run));
}

} // namespace

void BakeCommand::add_to(CLI::App& app) {
    add_run_options(app, options_);
    add_own_options(app);
    app.option_defaults()->group("Run");
    app.add_option("--also", also_,
                   "Another map of the same source, e.g. --also 'acm --sectors 8 -o OUT2'; repeatable. All maps appear, or none")
        ->type_name("'COMMAND OPTIONS -o OUT'")
        ->allow_extra_args(false);
}

Result<void> BakeCommand::run() {
    const Result<ConeCommandOptions> first = given();
    if (!first) return tl::unexpected(first.error());
    const Result<std::vector<ConePlan>> plans = plan_maps(*first, also_);
    if (!plans) return tl::unexpected(plans.error());
    const Result<std::optional<MemoryPlan>> memory = plan_bands(*plans);
    if (!memory) return tl::unexpected(memory.error());
    if (*memory) {
        const Result<BakedBands> bands = bake_bands(plans->front(), **memory);
        if (!bands) return tl::unexpected(bands.error());
        print(bands->baked, bands->report);
        return {};
    }
    const Result<BakedMaps> baked = bake_maps(*plans);
    if (!baked) return tl::unexpected(baked.error());
    print(*baked);
    return {};
}

Result<CommandFiles> BakeCommand::files() const {
    const FoldersMadeLater later;
    const Result<ConeCommandOptions> first = given();
    if (!first) return tl::unexpected(first.error());
    const Result<std::vector<ConePlan>> plans = plan_maps(*first, also_);
    if (!plans) return tl::unexpected(plans.error());
    CommandFiles files;
    files.inputs.push_back(first->input);
    files.max_bytes = first->read.max_bytes;
    files.sample_bytes = 0, files.planes = 0;
    for (const ConePlan& plan : *plans) {
        for (const std::vector<std::filesystem::path>& map : files_of(plan)) files.outputs.insert(files.outputs.end(), map.begin(), map.end());
        files.arguments += plan.argument_hash + (plan.given.relief_output.empty() ? "" : " relief") + "\n";
        files.sample_bytes = std::max(files.sample_bytes, double(bytes_of_sample(plan.bits)));
        files.planes = std::max(files.planes, double(plan.given.planes));
        files.mips = files.mips || plan.given.mips;
    }
    if (const std::string& alpha = first->alpha.from; !alpha.empty()) {
        const std::filesystem::path file = alpha; // a channel's name has no extension that a file would have
        if (file.has_extension()) files.inputs.push_back(file);
        else files.arguments += "alpha=" + alpha + "\n";
    }
    return files;
}

Result<ConeCommandOptions> parse_also(const std::string& text, const ConeCommandOptions& run) {
    const std::size_t begin = text.find_first_not_of(' '), end = text.find(' ', begin);
    const std::string name = begin == text.npos ? "" : text.substr(begin, end - begin);
    const std::unique_ptr<BakeCommand> command = make_bake_command(name);
    if (!command) return fail(ErrorCode::usage, start_of(text) + "expected cone, acm, cone-normal or cone-stack first, found '" + name + "'");
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    command->add_own_options(app);
    try {
        app.parse(end == text.npos ? "" : text.substr(end));
    } catch (const CLI::ParseError& error) {
        return fail(ErrorCode::usage, start_of(text) + error.what());
    }
    if (const std::vector<std::string> extras = app.remaining(); !extras.empty())
        return fail(ErrorCode::usage, start_of(text) + why_not(extras.front()));
    Result<ConeCommandOptions> given = command->given();
    if (!given) return fail(ErrorCode::usage, start_of(text) + given.error().message);
    copy_run_options(run, *given);
    return given;
}

Result<std::vector<ConePlan>> plan_maps(const ConeCommandOptions& first, const std::vector<std::string>& also) {
    std::vector<ConePlan> plans;
    const Result<ConePlan> plan = plan_cone(first);
    if (!plan) return tl::unexpected(plan.error());
    plans.push_back(*plan);
    for (const std::string& text : also) {
        const Result<ConeCommandOptions> given = parse_also(text, first);
        if (!given) return tl::unexpected(given.error());
        const Result<ConePlan> planned = plan_cone(*given);
        if (!planned) return fail(planned.error().code, start_of(text) + planned.error().message);
        plans.push_back(*planned);
    }
    if (Result<void> apart = validate_outputs(plans); !apart) return tl::unexpected(apart.error());
    return plans;
}

} // namespace reliefbake

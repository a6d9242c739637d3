#include "cli/advise/advise.h"

#include "cli/advise/apply_advice.h"
#include "cli/advise/sample_tile.h"
#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "cli/options/thread_option.h"
#include "cli/output_checks.h"
#include "formats/map_kind.h"

#include <algorithm>
#include <cstdio>

namespace reliefbake {
namespace {

constexpr int usual_rays = 60000;
constexpr int screened_part = 4; ///< the screen has so few of the rays

const Words<ShaderTarget> target_words = {{"glsl", ShaderTarget::glsl}, {"glsl-es", ShaderTarget::glsl_es}, {"hlsl", ShaderTarget::hlsl}};

const NumberRule error_limit = {[](double x) { return x > 0 && x <= 1; }, "a height above 0 and up to 1, the whole depth"};
const NumberRule view_angle = {[](double x) { return x >= 1 && x <= 89.9; }, "degrees from 1 to 89.9, e.g. 80 or 80deg"};

double require_angle(std::string given) {
    if (given.ends_with("deg")) given.resize(given.size() - 3);
    return require_number("--angle", given, view_angle);
}

} // namespace

void AdviseCommand::add_budget(CLI::App& app) {
    app.option_defaults()->group("Budget");
    add_number(app, "--max-missed", budget_.max_missed, fraction_number, "Share of rays that may be missed, 0 to 1: may go on beyond their first hit by more than 1/256 of the depth; 0: only what is promised to miss none is tried")->required();
    add_number(app, "--max-error", budget_.max_error, error_limit, "Mean height between the end of a ray and its exact hit, parts of the depth")->required();
    app.add_option("--steps", budget_.steps, "Most rounds of any ray, those that refine included (default 128)")->check(CLI::Range(1, 100000));
    add_number(app, "--bytes-per-texel", budget_.bytes_per_texel, positive_number, "Most bytes of all channels, for a texel of the source (default: any)");
    app.add_option_function<std::string>("--angle", [this](const std::string& given) { judge_.steepest = require_angle(given); }, "Steepest angle of the views from the plane's normal, degrees (default 80)")
        ->type_name("DEGREES");
    add_choice(app, "--target", target_, target_words,
               "What the shader can be: glsl: all; glsl-es: all, in 8 bits or halfs; hlsl: marches over cones, as `shader --language hlsl` writes them (default glsl)");
}

void AdviseCommand::add_to(CLI::App& app) {
    judge_.rays = usual_rays, judge_.repeat = 1;
    add_input_options(app, given_);
    add_budget(app);
    app.option_defaults()->group("Measuring");
    app.add_option("--rays", judge_.rays, "Rays of a proof, over all views, about; the screen has a quarter (default 60000)")->check(CLI::Range(2800, 10000000));
    app.add_option("--crop", crop_, "Side of the square in the middle of a larger map that candidates are screened on (default 128)")->check(CLI::Range(16, 16384));
    add_thread_option(app, given_.cone.threads);
    app.option_defaults()->group("Result");
    CLI::Option* apply = app.add_flag("--apply", apply_, "Bake the answer, exactly as measured");
    CLI::Option* output = app.add_option("-o,--output", output_, "Map to write: .png .tif .exr; what the format cannot hold in one file is not advised")->type_name("OUT");
    apply->needs(output), output->needs(apply);
    app.add_flag("--json", json_, "Print the result (cli/schema/advise.schema.json)");
}

Result<void> AdviseCommand::check_options() {
    const Result<int> threads = resolve_threads(given_.cone.threads);
    if (!threads) return tl::unexpected(threads.error());
    given_.cone.threads = judge_.threads = *threads;
    depth_scale_ = depth_scale_of(given_);
    if (budget_.max_missed > 0 && budget_.max_missed * judge_.rays < 1)
        return fail(ErrorCode::usage, "--max-missed: " + std::to_string(judge_.rays) + " rays cannot tell so small a share; give 0, or more --rays");
    return validate_depth_scale(depth_scale_).and_then([&] { return apply_ ? check_apply(given_.input, output_) : Result<void>(); });
}

Result<Measurement> AdviseCommand::prove(Bench& bench, const Candidate& candidate) {
    if (!bench.proof) {
        Result<CandidateMeter> made = CandidateMeter::create(bench.source, depth_scale_, judge_);
        if (!made) return tl::unexpected(made.error());
        bench.proof.emplace(std::move(*made));
    }
    return bench.proof->measure(candidate);
}

Result<Measurement> AdviseCommand::screen(Bench& bench, const Candidate& candidate, const AdviceReport& report) {
    const double widths = report.crop > 0 ? double(report.width) / (2 * report.crop) : 1;
    if (!bench.screen) {
        if (report.crop > 0) {
            Result<HeightField> tile = sample_tile(*bench.source.field, report.crop, given_.input);
            if (!tile) return tl::unexpected(tile.error());
            bench.tile = BakeSource{bench.source.image, "", bench.source.report, std::move(*tile)};
        }
        JudgeOptions few = judge_;
        few.rays = report.screen_rays;
        Result<CandidateMeter> made = CandidateMeter::create(bench.tile ? *bench.tile : bench.source, depth_scale_ * widths, few);
        if (!made) return tl::unexpected(made.error());
        bench.screen.emplace(std::move(*made));
    }
    Result<Measurement> figures = bench.screen->measure(on_tile(candidate, widths));
    if (!figures) return figures;
    figures->bytes_per_texel = source_bytes_per_texel(candidate, report.width, report.height);
    figures->bytes = figures->bytes_per_texel * report.width * report.height;
    return figures;
}

Result<void> AdviseCommand::find(Bench& bench, AdviceReport& report) {
    const TexelGrid& grid = bench.source.field->grid();
    report.width = grid.width, report.height = grid.height;
    const bool large = std::min(grid.width, grid.height) > crop_ && double(grid.width) * grid.height > 4.0 * crop_ * crop_;
    report.crop = large ? crop_ : 0;
    report.screen_rays = judge_.rays / screened_part;
    report.plan = plan_advice(grid.width, grid.height, budget_, target_, [&](const Representation& map) { return !apply_ || can_hold(output_, map); });

    ProgressLine progress(true);
    std::size_t number = 0;
    const auto told = [&](const Candidate& candidate, const char* stage, auto measure) -> Result<Measurement> {
        progress.set_stage(std::to_string(++number) + ", " + stage + " " + id_of(candidate));
        const Result<Measurement> figures = measure();
        if (!figures) return fail(figures.error().code, given_.input + ": " + id_of(candidate) + ": " + figures.error().message);
        return figures;
    };
    Measurers measurers;
    measurers.screen = [&](const Candidate& candidate) { return told(candidate, "screening", [&] { return screen(bench, candidate, report); }); };
    measurers.prove = [&](const Candidate& candidate) { return told(candidate, "proving", [&] { return prove(bench, candidate); }); };
    Result<Advice> advice = search_advice(report.plan.ways, budget_, measurers);
    if (!advice) return tl::unexpected(advice.error());
    report.advice = std::move(*advice);
    return {};
}

Result<void> AdviseCommand::apply(Bench& bench, AdviceReport& report) {
    const Trial& answer = report.advice.trials[*report.advice.choice.answer];
    const auto measure = [&](const ReliefMap& map) { return bench.proof->measure_baked(map, answer.candidate); };
    if (Result<void> applied = apply_advice(given_, output_, answer, measure); !applied) return applied;
    report.applied = output_;
    return {};
}

Result<void> AdviseCommand::run() {
    if (Result<void> checked = check_options(); !checked) return checked;
    const Result<std::string> kind = kind_of_map(given_.input, given_.read.max_bytes);
    if (!kind) return tl::unexpected(kind.error());
    if (!kind->empty()) return fail(ErrorCode::usage, given_.input + ": is a map that is baked, of kind " + *kind + "; give the heights it was baked from");
    StageClock clock(false);
    Result<BakeSource> source = read_source(given_, clock);
    if (!source) return tl::unexpected(source.error());
    Bench bench{std::move(*source), {}, {}, {}};
    AdviceReport report;
    report.input = given_.input, report.depth_scale = depth_scale_, report.target = target_, report.budget = budget_, report.judge = judge_;
    if (Result<void> found = find(bench, report); !found) return found;
    const bool met = report.advice.choice.answer.has_value();
    if (met && apply_)
        if (Result<void> applied = apply(bench, report); !applied) return applied;
    std::fputs((json_ ? advice_json(report).dump(1) + "\n" : advice_text(report)).c_str(), stdout);
    if (met) return {};
    return fail(ErrorCode::budget, nearest_text(report));
}

} // namespace reliefbake

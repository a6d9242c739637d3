#include "cli/tradeoff/tradeoff.h"

#include "cli/argument_hash.h"
#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "cli/options/range_option.h"
#include "cli/options/thread_option.h"
#include "cli/options/wrap_option.h"
#include "cli/render/render_choices.h"
#include "cli/report/format_text.h"
#include "cli/tradeoff/measure_candidate.h"
#include "cli/tradeoff/number_lists.h"
#include "cli/version.h"
#include "formats/atomic_file.h"
#include "formats/whole_file.h"
#include "formats/write_image.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>

namespace reliefbake {
namespace {

namespace fs = std::filesystem;

constexpr double default_depth_scale = 0.1;
constexpr int quick_rays = 14000;
constexpr std::uint64_t largest_picture = 1u << 24; ///< bytes of a PNG of 160 x 108, and much more

std::string method_words() {
    std::string words;
    for (const Method& method : all_methods()) words += (words.empty() ? "" : ",") + std::string(method.word);
    return words;
}

std::vector<std::string> require_methods(const std::string& given) {
    const std::vector<std::string> words = list_parts("--techniques", given);
    for (const std::string& word : words)
        if (!find_method(word)) throw CLI::ValidationError("--techniques", "expected some of " + method_words() + ", found '" + word + "'");
    return words;
}

/// 1, 0.5, 0.25, ... as mip levels.
std::vector<int> require_levels(const std::string& given) {
    std::vector<int> levels;
    for (const std::string& part : list_parts("--resolutions", given)) {
        const double level = -std::log2(parse_number(part).value_or(0));
        if (!(level >= 0 && level <= 16) || level != std::floor(level)) throw CLI::ValidationError("--resolutions", "expected some of 1,0.5,0.25,..., found '" + part + "'");
        levels.push_back(int(level));
    }
    return levels;
}

std::vector<float> require_tolerances(const std::string& given) {
    std::vector<float> tolerances;
    for (const std::string& part : list_parts("--tolerances", given)) tolerances.push_back(float(require_number("--tolerances", part, fraction_number)));
    return tolerances;
}

Result<void> make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return fail(ErrorCode::cannot_create, folder.string() + ": cannot create the folder: " + error.message());
    return {};
}

Result<void> write_picture(const fs::path& path, const RgbImage& picture) { return write_png(path, picture.width, picture.height, 3, picture.rgb); }

} // namespace

void TradeoffCommand::add_axes(CLI::App& app) {
    app.option_defaults()->group("What is compared (lists A,B,...; the first value is the base)");
    const auto add_list = [&](const char* flag, auto assign, const char* help) {
        app.add_option_function<std::string>(flag, assign, help)->type_name("A,B,...");
    };
    const std::string words = "Techniques with the maps they want: " + method_words() + " (default: all up to exact-finish)";
    app.add_option_function<std::string>("--techniques", [this](const std::string& given) { axes_.methods = require_methods(given); }, words)->type_name("A,B,...");
    add_list("--steps", [this](const std::string& given) { axes_.steps = require_integers("--steps", given, 1, 100000); }, "Steps of the march or the search (default 8,16,32,64,128)");
    add_list("--refinements", [this](const std::string& given) { axes_.refinements = require_integers("--refinements", given, 0, 100); }, "Halvings or secants (default 8,4)");
    add_choices(app, "--encodings", axes_.encodings, encoding_words, "How cones are stored (default sqrt,ratio,radius,normal)");
    add_choices(app, "--bits", axes_.bits, bits_words, "Depth of the channels: 8,16,half,float (default 16,8,float)");
    add_list("--resolutions", [this](const std::string& given) { axes_.levels = require_levels(given); }, "Texels an axis beside the source's: mip levels (default 1,0.5,0.25)");
    add_list("--tolerances", [this](const std::string& given) { axes_.tolerances = require_tolerances(given); }, "How much narrower than exact a cone may be, relative (default 0.001,0.01,0.1)");
    app.add_flag("--full", axes_.full, "Every combination, not one axis at a time");
    app.add_flag("--quick", quick_, "Steps 8,32,128, no further values of the other axes, 14000 rays, each view drawn once; what is given wins");
}

void TradeoffCommand::add_to(CLI::App& app) {
    app_ = &app;
    app.add_option("FILES", files_, "Height maps, or baked maps (then what each allows)")->required()->type_name("MAP|HEIGHT");
    app.add_option("-o,--output", folder_, "Folder for measurements, tables, plots and the page; a run goes on where an earlier one was interrupted (default tradeoff)")->type_name("DIR");
    app.add_flag("--json", json_, "Print the result (cli/schema/tradeoff.schema.json), too");
    add_axes(app);
    app.option_defaults()->group("Heights");
    app.add_option("--channel", given_.read.channel, "Channel of the heights (default: the only one, else luminance)");
    add_choice(app, "--input", given_.height.input, input_words, "What white means (default height)");
    add_range_option(app, given_.height);
    add_wrap_option(app, given_.height.wrap_x, given_.height.wrap_y);
    add_number(app, "--depth-uv", given_.depth_uv, positive_number, "Depth of the relief in texture widths (default 0.1)");
    app.add_option("--crop", crop_, "Side of the square in the middle that is measured, clamped; 0: all (default 0)")->check(CLI::Range(0, 65536));
    add_byte_budget(app, given_.read.max_bytes);
    app.option_defaults()->group("Measuring");
    app.add_option("--angle", judge_.steepest, "Steepest angle of the views from the plane's normal, degrees (default 80)")->check(CLI::Range(1.0, 89.9));
    app.add_option("--rays", judge_.rays, "Rays over all views, about (default 60000)")->check(CLI::Range(700, 10000000));
    app.add_option("--missed-depth", judge_.missed_depth, "Height beyond the first hit that makes a ray missed, or early (default 1/256)")->check(CLI::Range(1e-6, 1.0));
    app.add_option("--repeat", judge_.repeat, "Frames timed of each view, the fastest counts (default 2)")->check(CLI::Range(1, 100));
    add_choice(app, "--renderer", judge_.backend, renderer_words, "Who draws (default osmesa)");
    add_thread_option(app, judge_.threads);
}

void TradeoffCommand::apply_quick() {
    const auto given = [&](const char* flag) { return app_->get_option(flag)->count() > 0; };
    if (!given("--steps")) axes_.steps = {8, 32, 128};
    if (!given("--refinements")) axes_.refinements.resize(1);
    if (!given("--encodings")) axes_.encodings.resize(1);
    if (!given("--bits")) axes_.bits.resize(1);
    if (!given("--resolutions")) axes_.levels.resize(1);
    if (!given("--tolerances")) axes_.tolerances.resize(1);
    if (!given("--rays")) judge_.rays = quick_rays;
    if (!given("--repeat")) judge_.repeat = 1;
}

Result<TradeoffCommand::Input> TradeoffCommand::sweep(const std::string& file, const std::string& name, SweepRecord& record) {
    ConeCommandOptions given = given_;
    given.input = file;
    Result<TradeoffInput> read = read_tradeoff_input(given, crop_);
    if (!read) return tl::unexpected(read.error());
    Input input{std::move(*read), {file, name, 0, 0, "", {}}, "", ""};
    input.section.width = input.read.width, input.section.height = input.read.height;
    const double depth_scale = input.read.map ? input.read.map->info.depth_scale : given_.depth_uv.value_or(default_depth_scale);
    input.key = input.read.hash + "\n" + version() + "\n" + digits(depth_scale) + "\n" + digits(judge_.steepest) + "\n" + std::to_string(judge_.rays) + "\n" + digits(judge_.missed_depth) +
                "\n" + std::to_string(judge_.repeat) + "\n" + word_of(renderer_words, judge_.backend) + "\n";
    input.section.pictures = "pictures/" + hash_of_options(input.key).substr(0, 12);
    input.pictures = folder_ + "/" + input.section.pictures;

    const std::vector<PlannedCandidate> planned = input.read.map ? plan_marches(stored_representation(*input.read.map), axes_) : plan_sweep(axes_);
    if (planned.empty()) return fail(ErrorCode::usage, file + ": none of the techniques marches over it");
    std::optional<CandidateMeter> meter; // made when something is left to measure
    ProgressLine progress(true);
    std::size_t number = 0;
    const auto measure = [&](const Candidate& candidate) -> Result<Measurement> {
        progress.set_stage(name + ": " + std::to_string(number) + " of " + std::to_string(planned.size()) + ", " + id_of(candidate));
        if (!meter) {
            Result<CandidateMeter> made = input.read.map ? CandidateMeter::create(*input.read.map, judge_) : CandidateMeter::create(*input.read.source, depth_scale, judge_);
            if (!made) return tl::unexpected(made.error());
            meter.emplace(std::move(*made));
        }
        Result<Measurement> figures = meter->measure(candidate);
        if (!figures) return fail(figures.error().code, file + ": " + id_of(candidate) + ": " + figures.error().message);
        return figures;
    };
    const auto key_of = [&](const std::string& id) { return ++number, hash_of_options(input.key + id); };
    Result<SweepResult> swept = run_sweep(planned, record, key_of, measure);
    if (!swept) return tl::unexpected(swept.error());
    measured_anew_ += swept->measured_anew;
    input.section.candidates = std::move(swept->candidates);
    progress.set_stage(name + ": pictures");
    if (Result<void> drawn = draw_front(input); !drawn) return tl::unexpected(drawn.error());
    return input;
}

Result<void> TradeoffCommand::draw_front(const Input& input) const {
    std::set<std::size_t> wanted; // in the order that shares bakes
    for (const TradeoffCost& cost : tradeoff_costs())
        for (const std::size_t k : front_of(input.section, cost)) wanted.insert(k);
    if (Result<void> made = make_folder(input.pictures); !made) return made;
    std::optional<CandidateMeter> meter;
    JudgeOptions few = judge_;
    few.rays = 0; // the views that are judged are not drawn
    const double depth_scale = given_.depth_uv.value_or(default_depth_scale);
    for (const std::size_t k : wanted) {
        const Candidate& candidate = input.section.candidates[k].planned.candidate;
        const fs::path colour = input.pictures + "/" + id_of(candidate) + ".png", error = input.pictures + "/" + id_of(candidate) + "-error.png";
        if (fs::exists(colour) && fs::exists(error)) continue;
        if (!meter) {
            Result<CandidateMeter> made = input.read.map ? CandidateMeter::create(*input.read.map, few) : CandidateMeter::create(*input.read.source, depth_scale, few);
            if (!made) return tl::unexpected(made.error());
            meter.emplace(std::move(*made));
        }
        const Result<JudgePicture> picture = meter->picture(candidate);
        if (!picture) return tl::unexpected(picture.error());
        Result<void> written = write_picture(colour, picture->colour).and_then([&] { return write_picture(error, picture->error); });
        if (!written) return written;
    }
    return {};
}

Result<void> TradeoffCommand::write(const std::vector<TradeoffSection>& sections, const std::vector<Input>& inputs) const {
    const fs::path folder = folder_;
    const double depth_scale = given_.depth_uv.value_or(default_depth_scale);
    Error unread{ErrorCode::no_input, ""};
    const PicturesOf pictures_of = [&](const TradeoffSection& section, const std::string& id) {
        const std::size_t k = std::size_t(&section - sections.data());
        const Result<std::string> colour = read_whole_file(inputs[k].pictures + "/" + id + ".png", largest_picture);
        const Result<std::string> error = read_whole_file(inputs[k].pictures + "/" + id + "-error.png", largest_picture);
        if (!colour) unread = colour.error();
        if (!error) unread = error.error();
        return PngPair{colour.value_or(""), error.value_or("")};
    };
    const nlohmann::json json = tradeoff_json(sections, judge_, depth_scale);
    const std::string page = tradeoff_html(sections, judge_, depth_scale, pictures_of);
    if (!unread.message.empty()) return tl::unexpected(unread);
    Result<void> written = write_file_atomically(folder / "tradeoff.csv", tradeoff_csv(sections))
                               .and_then([&] { return write_file_atomically(folder / "tradeoff.json", json.dump(1) + "\n"); })
                               .and_then([&] { return write_file_atomically(folder / "tradeoff.html", page); });
    for (const TradeoffSection& section : sections)
        for (const TradeoffCost& cost : tradeoff_costs())
            if (written && cost.plotted) written = write_file_atomically(folder / (section.name + "-" + cost.word + ".svg"), tradeoff_svg(section, cost));
    if (written && json_) std::puts(json.dump(1).c_str());
    return written;
}

Result<void> TradeoffCommand::run() {
    if (quick_) apply_quick();
    const Result<int> threads = resolve_threads(judge_.threads);
    if (!threads) return tl::unexpected(threads.error());
    judge_.threads = *threads;
    if (Result<void> made = make_folder(folder_); !made) return made;
    Result<SweepRecord> record = SweepRecord::open(folder_);
    if (!record) return tl::unexpected(record.error());
    std::vector<Input> inputs;
    std::set<std::string> names;
    for (const std::string& file : files_) {
        std::string name = fs::path(file).stem().string();
        for (int k = 2; !names.insert(name).second; ++k) name = fs::path(file).stem().string() + "-" + std::to_string(k);
        Result<Input> input = sweep(file, name, *record);
        if (!input) return tl::unexpected(input.error());
        input->read.source.reset(), input->read.map.reset();
        inputs.push_back(std::move(*input));
    }
    std::vector<TradeoffSection> sections;
    std::size_t points = 0;
    for (const Input& input : inputs) sections.push_back(input.section), points += input.section.candidates.size();
    if (Result<void> written = write(sections, inputs); !written) return written;
    if (!json_) std::printf("%zu measurements, %zu of them new: %s/tradeoff.html, .csv, .json\n", points, measured_anew_, folder_.c_str());
    return {};
}

} // namespace reliefbake

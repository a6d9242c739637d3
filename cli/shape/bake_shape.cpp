#include "cli/shape/bake_shape.h"

#include "cli/command_output.h"
#include "cli/shape/shape_report.h"
#include "cli/stage_clock.h"
#include "cli/version.h"
#include "formats/shape_file.h"

#include <algorithm>
#include <utility>

namespace reliefbake {

namespace {

/// Whether a fair part of the samples lies on either side of the threshold: a stray transparent texel cuts out no shape.
bool holds_shape(const Image<float>& samples, double threshold) {
    constexpr std::ptrdiff_t least_part = 256; // 1 / 256 of them
    const auto bright = std::count_if(samples.begin(), samples.end(), [&](float v) { return double(v) >= threshold; });
    const auto all = std::ptrdiff_t(samples.size());
    return std::min(bright, all - bright) * least_part >= all;
}

/// The channel asked for; else the alpha if a shape is cut out of it, else luminance.
Result<SourceImage> read_samples(const ShapePlan& plan) {
    const ShapeCommandOptions& given = plan.given;
    Result<SourceImage> source = read_image(given.input, given.read);
    if (!source || !given.read.channel.empty()) return source;
    const std::vector<std::string>& names = source->channel_names;
    if (names.size() < 2 || std::find(names.begin(), names.end(), "A") == names.end()) return source;
    ReadOptions alpha_options = given.read;
    alpha_options.channel.assign(1, 'A');
    Result<SourceImage> alpha = read_image(given.input, alpha_options);
    if (!alpha || holds_shape(alpha->plane, plan.shape.threshold)) return alpha;
    return source;
}

/// "A", or the alpha of a layer.
bool is_alpha(const std::string& channel) { return channel == "A" || channel.ends_with(".A"); }

void tell(const ShapeRun& run) {
    const ShapeCommandOptions& given = run.plan.given;
    for (const std::string& warning : run.warnings) print_warning("shape", warning);
    if (given.quiet) return;
    print_result(given.json ? shape_result_text(run) : shape_summary(run));
}

} // namespace

void ShapeCommand::add_to(CLI::App& app) { add_shape_options(app, options_); }

Result<CommandFiles> ShapeCommand::files() const {
    const FoldersMadeLater later;
    const Result<ShapePlan> plan = plan_shape(options_);
    if (!plan) return tl::unexpected(plan.error());
    CommandFiles files;
    files.inputs.push_back(options_.input);
    files.outputs.push_back(options_.output);
    files.arguments = argument_hash(*plan, options_.read.channel) + "\n";
    files.sample_bytes = double(bytes_of_sample(plan->bake.bits));
    files.max_bytes = options_.read.max_bytes;
    return files;
}

Result<void> ShapeCommand::run() {
    Result<ShapePlan> plan = plan_shape(options_);
    if (!plan) return tl::unexpected(plan.error());
    StageClock clock(!options_.quiet);

    Result<SourceImage> source = clock.time("read", [&] { return read_samples(*plan); });
    if (!source) return tl::unexpected(source.error());
    plan->shape.bright_is_inside = is_alpha(source->channel);
    const Result<BinaryShape> shape =
        clock.time("shape", [&] { return make_shape(std::move(source->plane), plan->shape, options_.input); });
    if (!shape) return tl::unexpected(shape.error());

    Result<ShapeMap> map = clock.time("bake", [&] { return bake_shape_map(*shape, plan->bake); });
    if (!map) return tl::unexpected(map.error());
    map->info.inverted = plan->shape.invert;
    map->info.named = options_.named;
    map->info.version = version();
    map->info.source_hash = source->pixel_hash;
    map->info.argument_hash = argument_hash(*plan, source->channel);
    const std::vector<std::string> warnings = shape_warnings(options_, *shape, map->info);

    const Result<void> written = clock.time("write", [&] { return write_shape_map(options_.output, *map, plan->bake.threads); });
    if (!written) return written;
    clock.stop();
    tell({*plan, *source, map->info, map->grid, warnings, clock.seconds()});
    return {};
}

} // namespace reliefbake

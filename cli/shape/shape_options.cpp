#include "cli/shape/shape_options.h"

#include "cli/argument_hash.h"
#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "cli/options/thread_option.h"
#include "cli/options/wrap_option.h"
#include "cli/output_checks.h"
#include "cli/report/format_text.h"
#include "cli/shape/shape_choices.h"
#include "formats/shape_file.h"

namespace reliefbake {

namespace {

/// The shortest digits that read back as the same number, in every locale.
const Words<bool> exr_layout_words = {{"rgba", false}, {"named", true}};

const NumberRule above_zero_to_one = {[](double v) { return v > 0 && v <= 1; }, "a number above 0, at most 1"};

void add_source_options(CLI::App& app, ShapeCommandOptions& o) {
    app.option_defaults()->group("Source");
    app.add_option("--channel", o.read.channel,
                   "R|G|B|A|Y (luminance) or a channel's name (default: the alpha where it has a shape, else luminance)");
    add_number(app, "--threshold", o.threshold, fraction_number, "Sample from which on a texel is bright (default 0.5)");
    app.add_flag("--invert", o.invert, "Take the other side (default: what is opaque in an alpha, dark in any other channel)");
    add_told_wrap(app, o.wrap_x, o.wrap_y, "repeat: the shape tiles, and distances reach across its border (default clamp)");
    add_byte_budget(app, o.read.max_bytes);
}

void add_bake_options(CLI::App& app, ShapeCommandOptions& o) {
    app.option_defaults()->group("Bake");
    CLI::Option* model = add_choice(app, "--model", o.model, given_model_words,
                                    "What the shape is: the squares of its texels, or their centres alone (default squares)");
    app.add_flag("--antialiased", o.antialiased,
                 "Samples between dark and bright are parts of texels: distances to the edge inside them")
        ->excludes(model);
    add_choice(app, "--method", o.bake.method, method_words,
               "exact, or the papers' vector propagation, which is a little wrong here and there (default exact)");
    app.add_flag("--signed", o.bake.signed_distance, "Inside the shape, minus the distance to its outside");
    add_number(app, "--scale-f", o.bake.scale_f, above_zero_to_one,
               "Share of the largest distance that the codes span; what is farther is stored as that (default 1)");
    add_thread_option(app, o.bake.threads);
}

void add_result_options(CLI::App& app, ShapeCommandOptions& o) {
    app.option_defaults()->group("Result");
    app.add_option("-o,--output", o.output, "Map to write: .png .tif .exr .tga .dds .ktx2")->required()->type_name("OUT");
    add_choice(app, "--bits", o.bits, bits_words, "Depth of the channels (default 16; exr: float; tga: 8)");
    add_choice(app, "--exr-layout", o.named, exr_layout_words,
               "Channels R,G,B,A or shape.gx, shape.gy, shape.distance, shape.mask (default rgba)");
    CLI::Option* json = app.add_flag("--json", o.json, "Print one result object (cli/schema/shape.schema.json)");
    app.add_flag("--quiet", o.quiet, "Print nothing unless something is wrong")->excludes(json);
}

Result<void> check_combination(const ShapeCommandOptions& o) {
    if (o.antialiased && o.threshold)
        return fail(ErrorCode::usage, "--threshold: an anti-aliased edge lies where half of a texel is covered; leave it out with --antialiased");
    if (o.bake.method == DistanceMethod::danielsson && (o.antialiased || o.model == ShapeModel::squares))
        return fail(ErrorCode::usage, "--method danielsson: measures to texel centres alone; use --model centres");
    if (o.bake.method == DistanceMethod::danielsson && (o.wrap_x == Wrap::repeat || o.wrap_y == Wrap::repeat))
        return fail(ErrorCode::usage, "--method danielsson: does not reach around a tile's border; leave out --wrap");
    if (o.named && extension_of(o.output) != ".exr")
        return fail(ErrorCode::usage, "--exr-layout: needs an .exr output, found '" + o.output + "'");
    return {};
}

} // namespace

void add_shape_options(CLI::App& app, ShapeCommandOptions& options) {
    app.add_option("IN", options.input, "Picture of the shape: png, tif, exr, hdr, jpg, tga, bmp, pgm, ppm, pfm")->required();
    add_source_options(app, options);
    add_bake_options(app, options);
    add_result_options(app, options);
}

Result<ShapePlan> plan_shape(const ShapeCommandOptions& options) {
    ShapePlan plan;
    plan.given = options;
    plan.bake = options.bake;
    plan.bake.bits = options.bits.value_or(default_bits(options.output));
    const bool centres = options.bake.method == DistanceMethod::danielsson;
    plan.shape.model = options.antialiased ? ShapeModel::contour
                                           : options.model.value_or(centres ? ShapeModel::centres : ShapeModel::squares);
    plan.shape.threshold = options.threshold.value_or(plan.shape.threshold);
    plan.shape.invert = options.invert;
    plan.shape.wrap_x = options.wrap_x == Wrap::repeat;
    plan.shape.wrap_y = options.wrap_y == Wrap::repeat;
    ShapeMapInfo info;
    info.bits = plan.bake.bits;
    info.named = options.named;
    return validate_not_input(options.input, options.output)
        .and_then([&] { return check_combination(options); })
        .and_then([&] { return check_shape_format(options.output, info); })
        .and_then([&] { return validate_output_folder(options.output); })
        .and_then([&] { return resolve_threads(options.bake.threads); })
        .map([&](int threads) {
            plan.bake.threads = threads;
            return plan;
        });
}

std::string argument_hash(const ShapePlan& plan, const std::string& channel) {
    std::string text = "shape\nchannel=" + channel + "\nthreshold=" + digits(plan.shape.threshold);
    text += "\ninvert=" + std::to_string(plan.shape.invert);
    text += "\nwrap=" + std::to_string(plan.shape.wrap_x) + "," + std::to_string(plan.shape.wrap_y);
    text += "\nmodel=" + word_of(model_words, plan.shape.model) + "\nmethod=" + word_of(method_words, plan.bake.method);
    text += "\nsigned=" + std::to_string(plan.bake.signed_distance) + "\nscale-f=" + digits(plan.bake.scale_f);
    text += "\nbits=" + word_of(bits_words, plan.bake.bits) + "\nnamed=" + std::to_string(plan.given.named) + "\n";
    return hash_of_options(text);
}

} // namespace reliefbake

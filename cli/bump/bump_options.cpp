#include "cli/bump/bump_options.h"

#include "cli/argument_hash.h"
#include "cli/options/number_options.h"
#include "cli/options/thread_option.h"
#include "cli/output_checks.h"
#include "cli/report/format_text.h"
#include "cli/version.h"
#include "formats/bump_file.h"

#include <filesystem>

namespace reliefbake {

namespace {

const Words<ChannelLayout> bump_layout_words = {
    {"rgba", ChannelLayout::rgba}, {"named", ChannelLayout::named}, {"pair", ChannelLayout::pair}};

/// Options that say something about kinds that do not listen.
Result<void> refuse_unread(const BumpCommandOptions& o) {
    const std::string kind = "--kind " + word_of(bump_kind_words, o.kind);
    const auto refused = [](const std::string& words) { return fail(ErrorCode::usage, words); };
    const bool horizon = o.kind == BumpKind::horizon, derivative = o.kind == BumpKind::derivative;
    if (o.kernel && horizon) return refused(kind + ": is exact and takes no --kernel");
    if (o.codes && horizon) return refused(kind + ": sines are never negative; leave --codes out");
    if (o.derivative_max && !derivative) return refused("--derivative-max: is for --kind derivative");
    if (o.normal_y && o.kind != BumpKind::normal) return refused("--normal-y: is for --kind normal; derivatives are along u and v, v down the image");
    if (derivative && (o.height.depth_uv || o.height.size_metres))
        return refused(kind + ": derivatives are of heights 0 to 1, the shader's bump scale says how deep they are; leave --depth-uv, --size and --depth out");
    return {};
}

Result<void> validate_floats(const BumpCommandOptions& o, BitDepth bits) {
    if (is_unorm(bits)) return {};
    if (o.codes) return fail(ErrorCode::usage, "--codes: are for --bits 8 and 16; half and float channels hold signed values themselves");
    if (o.derivative_max) return fail(ErrorCode::usage, "--derivative-max: is for --bits 8 and 16; half and float channels hold derivatives themselves");
    return {};
}

Result<void> validate_outputs(const BumpCommandOptions& o, const BumpMapInfo& info) {
    for (const std::filesystem::path& file : bump_files(o.height.output, info))
        if (Result<void> other = validate_not_input(o.height.input, file.string()); !other) return other;
    return validate_output_folder(o.height.output);
}

ChannelLayout default_layout(const BumpCommandOptions& o) {
    if (o.kind != BumpKind::horizon) return ChannelLayout::rgba;
    return extension_of(o.height.output) == ".exr" ? ChannelLayout::named : ChannelLayout::pair;
}

std::string result_text(const BumpPlan& plan) {
    const BumpMapInfo& info = plan.info;
    std::string text = "\nkernel=" + word_of(kernel_words, info.kernel) + "\ncodes=" + word_of(codes_words, info.codes);
    if (plan.given.derivative_max) text += "\nderivative-max=" + digits(*plan.given.derivative_max);
    text += "\nnormal-y=" + word_of(normal_y_words, info.normal_y) + "\nbits=" + word_of(bits_words, info.bits);
    if (info.kind != BumpKind::derivative) text += "\ndepth-uv=" + digits(info.depth_scale);
    return text + "\nlayout=" + word_of(layout_words, info.layout) + "\n";
}

} // namespace

std::vector<std::filesystem::path> bump_files(const std::filesystem::path& output, const BumpMapInfo& info) {
    std::vector<std::filesystem::path> files;
    for (const BumpImage& image : bump_images(info))
        files.push_back(output.parent_path() / (output.stem().string() + image.suffix + output.extension().string()));
    return files;
}

void add_bump_options(CLI::App& app, BumpCommandOptions& o) {
    add_input_options(app, o.height);
    app.option_defaults()->group("Bake");
    add_choice(app, "--kind", o.kind, bump_kind_words,
               "dH/du, dH/dv and depth; normals and depth; or how high the relief stands before the sky in eight directions (default derivative)");
    add_choice(app, "--kernel", o.kernel, kernel_words, "Of derivatives and normals: how rows beside the texel count (default central)");
    add_thread_option(app, o.height.cone.threads);
    app.option_defaults()->group("Result");
    app.add_option("-o,--output", o.height.output, "Map to write: .png .tif .exr .tga")->required()->type_name("OUT");
    add_choice(app, "--bits", o.height.bits, bits_words, "Depth of the channels (default 16; exr: float; tga: 8)");
    add_choice(app, "--codes", o.codes, codes_words,
               "Signed values in integers: centred, zero is code 128 or 32768 and exact; unorm, 2 v - 1, as engines decode normals, "
               "no code is zero (default centred; normals: unorm)");
    add_number(app, "--derivative-max", o.derivative_max, positive_number,
               "Derivative of the largest integer code, so that several maps share it; a larger one is refused (default: the map's largest)");
    add_choice(app, "--normal-y", o.normal_y, normal_y_words, "Direction of the normals' y: up (OpenGL) or down (DirectX) the image (default gl)");
    add_choice(app, "--layout", o.layout, bump_layout_words,
               "Channels R,G,B(,A); named ones of an .exr; or, for horizons, two RGBA files, the second named ..._b (default rgba; horizons: named for .exr, else pair)");
    CLI::Option* json = app.add_flag("--json", o.height.json, "Print one result object (cli/schema/bump.schema.json)");
    app.add_flag("--quiet", o.height.quiet, "Print nothing unless something is wrong")->excludes(json);
}

Result<BumpPlan> plan_bump(const BumpCommandOptions& options) {
    BumpPlan plan;
    plan.given = options;
    BumpMapInfo& info = plan.info;
    info.kind = options.kind;
    info.bits = options.height.bits.value_or(default_bits(options.height.output));
    info.layout = options.layout.value_or(default_layout(options));
    info.codes = options.codes.value_or(options.kind == BumpKind::normal ? SignedCodes::unorm : SignedCodes::centred);
    info.kernel = options.kernel.value_or(DerivativeKernel::central);
    info.normal_y = options.normal_y.value_or(NormalY::gl);
    info.depth_scale = depth_scale_of(options.height);
    info.version = version();
    return refuse_unread(options)
        .and_then([&] { return check_bump_format(options.height.output, info); })
        .and_then([&] { return validate_floats(options, info.bits); })
        .and_then([&] { return validate_depth_scale(info.depth_scale); })
        .and_then([&] { return validate_outputs(options, info); })
        .and_then([&] { return resolve_threads(options.height.cone.threads); })
        .map([&](int threads) {
            plan.threads = threads;
            info.argument_hash = hash_of_options(word_of(bump_kind_words, info.kind) + "\n" + source_text(options.height) + result_text(plan));
            return plan;
        });
}

} // namespace reliefbake

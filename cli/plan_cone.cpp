#include "cli/cone_options.h"

#include "cli/argument_hash.h"
#include "cli/mip_options.h"
#include "cli/thread_option.h"
#include "formats/map_file.h"

#include <cerrno>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

std::string extension_of(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return extension;
}

/// The deepest codes that every program can read back from the format.
BitDepth default_bits(const std::string& output) {
    const std::string extension = extension_of(output);
    if (extension == ".exr") return BitDepth::float32;
    return extension == ".tga" ? BitDepth::unorm8 : BitDepth::unorm16;
}

Result<void> validate_output(const ConeCommandOptions& options) {
    std::error_code ignored;
    if (fs::equivalent(options.input, options.output, ignored))
        return fail(ErrorCode::usage, options.output + ": the output is the input file; choose another name");
    if (!options.relief_output.empty() && fs::path(options.relief_output).lexically_normal() == fs::path(options.output).lexically_normal())
        return fail(ErrorCode::usage, "--relief: is the output itself; choose another name");
    if (options.kind == "cone" && options.layout && extension_of(options.output) != ".exr")
        return fail(ErrorCode::usage, "--exr-layout: needs an .exr output, found '" + options.output + "'");
    return {};
}

/// Before the work, so that none is lost; the writer checks again.
Result<void> validate_output_folder(const std::string& output) {
    const fs::path parent = fs::path(output).parent_path();
    const fs::path folder = parent.empty() ? "." : parent;
    if (access(folder.c_str(), W_OK | X_OK) == 0) return {};
    return fail(ErrorCode::cannot_create, output + ": cannot create a file in " + folder.string() + ": " +
                                              std::generic_category().message(errno));
}

/// An unbounded cone has a finite code only as a normal, or as a radius beyond 1 in floats.
Result<void> validate_cone_max(const ConeCommandOptions& options, BitDepth bits) {
    const bool unbounded_codes = options.encoding == ConeEncoding::normal ||
                                 (options.encoding == ConeEncoding::radius && !is_unorm(bits));
    if (std::isfinite(options.cone.ratio_max) || unbounded_codes) return {};
    return fail(ErrorCode::usage,
                "--cone-max inf: needs --encoding normal, or --encoding radius with --bits half|float");
}

/// Steeper than anything; beyond, squares of slopes leave double's range.
constexpr double largest_depth_scale = 1e6;

Result<void> validate_depth_scale(double scale) {
    if (scale > 0 && scale <= largest_depth_scale) return {};
    return fail(ErrorCode::usage, "--depth-uv, or --depth over --size: expected a depth above 0 and up to 1e6 texture widths");
}

/// What the bake cannot make of a family.
Result<void> validate_kind(const ConeCommandOptions& options) {
    if (options.planes == 8 && options.kind == "acm" && options.cone.metric == Metric::l1)
        return fail(ErrorCode::usage, "--sectors 8: needs --metric l2; the borders of eight sectors are angles");
    if (options.kind != "cone" && options.cone.surface == SurfaceModel::texel)
        return fail(ErrorCode::usage, "--surface texel: is for `cone` alone");
    return {};
}

/// The facts of the map that a layout depends on.
ReliefMapInfo layout_facts(const ConePlan& plan) {
    ReliefMapInfo info;
    info.kind = plan.given.kind, info.planes = plan.given.kind == "cone" ? 0 : plan.given.planes;
    info.bits = plan.bits, info.layout = plan.layout;
    return info;
}

/// One EXR can hold everything; else the fewest files.
ChannelLayout default_layout(const ConeCommandOptions& options) {
    if (options.kind == "cone") return ChannelLayout::rgba;
    if (extension_of(options.output) == ".exr") return ChannelLayout::named;
    return options.planes == 8 ? ChannelLayout::side : ChannelLayout::rgba;
}

Result<void> validate_relief(const ConePlan& plan) {
    if (plan.given.relief_output.empty()) return {};
    if (plan.layout == ChannelLayout::named)
        return fail(ErrorCode::usage, "--relief: layout named holds depth and normals itself; leave --relief out");
    return check_map_format(plan.given.relief_output, plan.bits, ChannelLayout::rgba).and_then([&] {
        return validate_output_folder(plan.given.relief_output);
    });
}

double depth_scale_of(const ConeCommandOptions& options) {
    if (options.size_metres) return *options.depth_metres / *options.size_metres;
    return options.depth_uv.value_or(ReliefMapInfo().depth_scale);
}

} // namespace

Result<ConePlan> plan_cone(const ConeCommandOptions& options) {
    ConePlan plan;
    plan.given = options;
    plan.bits = options.bits.value_or(default_bits(options.output));
    plan.layout = options.layout.value_or(default_layout(options));
    plan.depth_scale = depth_scale_of(options);
    plan.cone = options.cone;
    return validate_output(options)
        .and_then([&] { return check_map_format(options.output, layout_facts(plan)); })
        .and_then([&] { return validate_relief(plan); })
        .and_then([&] { return validate_kind(options); })
        .and_then([&] { return resolve_family(options.family, plan.cone); })
        .and_then([&] { return validate_cone_max(options, plan.bits); })
        .and_then([&] { return validate_depth_scale(plan.depth_scale); })
        .and_then([&] { return validate_mips(options, plan.cone); })
        .and_then([&] { return validate_output_folder(options.output); })
        .and_then([&] { return resolve_threads(options.cone.threads); })
        .map([&](int threads) {
            plan.cone.threads = threads;
            plan.argument_hash = argument_hash(plan);
            return plan;
        });
}

} // namespace reliefbake

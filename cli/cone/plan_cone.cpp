#include "cli/cone/cone_options.h"

#include "cli/argument_hash.h"
#include "cli/cone/mip_options.h"
#include "cli/cone/plan_files.h"
#include "cli/options/thread_option.h"
#include "cli/output_checks.h"
#include "formats/map_file.h"

#include <cmath>
#include <filesystem>
#include <map>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

Result<void> validate_output(const ConeCommandOptions& options) {
    if (Result<void> other = validate_not_input(options.input, options.output); !other) return other;
    for (const std::string& output : {options.output, options.relief_output})
        if (Result<void> other = validate_not_input(options.alpha.from, output); !other) return other;
    if (options.kind == "cone" && options.layout && extension_of(options.output) != ".exr")
        return fail(ErrorCode::usage, "--exr-layout: needs an .exr output, found '" + options.output + "'");
    return {};
}

/// An unbounded cone has a finite code only as a normal, or as a radius beyond 1 in floats.
Result<void> validate_cone_max(const ConeCommandOptions& options, BitDepth bits) {
    const bool unbounded_codes = options.encoding == ConeEncoding::normal ||
                                 (options.encoding == ConeEncoding::radius && !is_unorm(bits));
    if (std::isfinite(options.cone.ratio_max) || unbounded_codes) return {};
    return fail(ErrorCode::usage,
                "--cone-max inf: needs --encoding normal, or --encoding radius with --bits half|float");
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
    info.bits = plan.bits, info.layout = plan.layout, info.held = plan.given.held;
    return info;
}

/// One EXR can hold everything; else the fewest files.
ChannelLayout default_layout(const ConeCommandOptions& options) {
    if (options.kind == "cone") return ChannelLayout::rgba;
    if (extension_of(options.output) == ".exr") return ChannelLayout::named;
    if (options.planes != 8 || options.kind != "acm") return ChannelLayout::rgba;
    return options.mips ? ChannelLayout::pair : ChannelLayout::side; // levels side by side would meet
}

/// A band file holds any map; else the format, by the extension, must.
Result<void> check_file_format(const ConeCommandOptions& options, const ConePlan& plan) {
    if (!options.large.rows) return check_map_format(options.output, layout_facts(plan));
    if (extension_of(options.output) == ".band") return {};
    return fail(ErrorCode::usage, "--rows: needs an output named .band, found '" + options.output + "'; merge makes a map of them");
}

Result<void> validate_relief(const ConePlan& plan) {
    if (plan.given.relief_output.empty()) return {};
    if (plan.layout == ChannelLayout::named)
        return fail(ErrorCode::usage, "--relief: layout named holds depth and normals itself; leave --relief out");
    return check_map_format(plan.given.relief_output, plan.bits, ChannelLayout::rgba).and_then([&] {
        return validate_output_folder(plan.given.relief_output);
    });
}

} // namespace

std::vector<std::vector<fs::path>> files_of(const ConePlan& plan) {
    std::vector<std::vector<fs::path>> files{map_files(plan.given.output, layout_facts(plan), plan.given.mips)};
    if (!plan.given.relief_output.empty()) files.push_back(map_files(plan.given.relief_output, ReliefMapInfo(), plan.given.mips));
    return files;
}

Result<void> validate_outputs(const std::vector<ConePlan>& plans) {
    std::map<std::string, int> seen; // and of which map
    int number = 0;
    for (const ConePlan& plan : plans)
        for (const std::vector<fs::path>& of_map : files_of(plan)) {
            ++number;
            for (const fs::path& file : of_map) {
                for (const std::string& input : {plan.given.input, plan.given.alpha.from})
                    if (Result<void> other = validate_not_input(input, file.string()); !other) return other;
                if (seen.emplace(identity_of(file), number).first->second != number)
                    return fail(ErrorCode::usage, file.string() + ": two maps of this run would be written to it; choose another name");
            }
        }
    return {};
}

Result<ConePlan> plan_cone(const ConeCommandOptions& options) {
    ConePlan plan;
    plan.given = options;
    plan.bits = options.bits.value_or(default_bits(options.output));
    plan.layout = options.layout.value_or(default_layout(options));
    plan.depth_scale = depth_scale_of(options);
    plan.cone = options.cone;
    return validate_output(options)
        .and_then([&] { return check_file_format(options, plan); })
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

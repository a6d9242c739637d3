#include "cli/cone/large/bake_bands.h"

#include "bake/cone_bands.h"
#include "cli/output_checks.h"
#include "formats/decode_session.h"
#include "formats/join_bands.h"
#include "formats/map_layout.h"
#include "formats/map_pixels.h"

#include <filesystem>
#include <string>
#include <system_error>

namespace reliefbake {

namespace {

std::uint64_t pixel_bytes(const ConePlan& plan) {
    const std::uint64_t channels = 1 + 2 * plan.given.held.normals + plan.given.held.cones;
    return channels * std::uint64_t(sample_bytes_of(plan.bits));
}

/// What a map by bands has not. Empty: nothing is asked that it has not.
std::string missing(const std::vector<ConePlan>& plans) {
    const ConePlan& plan = plans.front();
    const ConeCommandOptions& given = plan.given;
    if (plans.size() > 1) return "--also";
    if (given.kind != "cone") return given.command;
    if (plan.cone.family != ConeFamily::conservative) return "--kind";
    if (given.mips || given.mip_levels || given.trilinear) return "--mips";
    if (given.level > 0) return "--level";
    if (!given.alpha.from.empty()) return "--alpha";
    if (given.height.nan == NanPolicy::fill) return "--nan fill";
    if (!given.held.cones) return "--channels without cone";
    return {};
}

Result<void> check_rows(const ConePlan& plan, int height) {
    if (!plan.given.large.rows) return {};
    const auto [first, end] = *plan.given.large.rows;
    const std::string found = std::to_string(first) + ":" + std::to_string(end);
    if (end > height) return fail(ErrorCode::usage, "--rows " + found + ": " + plan.given.input + " has rows 0:" + std::to_string(height));
    if (first % band_step == 0 && (end % band_step == 0 || end == height)) return {};
    return fail(ErrorCode::usage, "--rows " + found + ": expected multiples of " + std::to_string(band_step) + ", or " + std::to_string(height) + " as the end");
}

/// Whether a file's size alone says that its bake stays far below the default ceiling: none of more than 1000 samples a byte is read.
bool is_small(const ConePlan& plan) {
    std::error_code error;
    const std::uint64_t bytes = std::filesystem::file_size(plan.given.input, error);
    return error || in_core_bytes(1000 * bytes, pixel_bytes(plan)) <= LargeOptions::default_memory;
}

/// Of a file that is read whole, when a ceiling was given for it: the sides are known once it is open. Whatever is wrong with the file
/// is told by who reads it.
Result<void> check_whole(const ConePlan& plan) {
    const ConeCommandOptions& given = plan.given;
    if (!given.large.memory) return {};
    const Result<DecodeSession> session = DecodeSession::open(given.input, given.read.max_bytes, 1);
    if (!session) return {};
    const std::uint64_t texels = std::uint64_t(session->claims().width) * std::uint64_t(session->claims().height), needed = in_core_bytes(texels, pixel_bytes(plan));
    if (needed <= given.large.ceiling()) return {};
    return fail(ErrorCode::budget, given.input + ": needs " + std::to_string(needed >> 20) + " MiB, and --memory allows " + std::to_string(given.large.ceiling() >> 20) +
                                       " MiB; only EXR and TIFF files are baked out of core");
}

/// The map's file takes rows one after the other.
Result<void> check_output(const ConePlan& plan, std::uint64_t bytes) {
    return plan.given.large.rows ? Result<void>() : check_streamed_format(plan.given.output, bytes);
}

} // namespace

Result<std::optional<MemoryPlan>> plan_bands(const std::vector<ConePlan>& plans) {
    const ConePlan& plan = plans.front();
    const LargeOptions& large = plan.given.large;
    const bool told = large.out_of_core || large.rows;
    const std::string lacks = missing(plans);
    if (told && !lacks.empty()) return fail(ErrorCode::usage, std::string(large.rows ? "--rows" : "--out-of-core") + ": cannot be had with " + lacks + "; leave one of them out");

    if (!told && !large.memory && is_small(plan)) return std::optional<MemoryPlan>();
    const Result<ImageSides> sides = look_at_sides(plan.given.input, plan.given.read);
    if (!sides) {
        // What cannot be looked at in this way is read whole, and refused there if need be.
        if (told) return tl::unexpected(sides.error());
        return check_whole(plan).map([] { return std::optional<MemoryPlan>(); });
    }
    const std::uint64_t texels = std::uint64_t(sides->width) * std::uint64_t(sides->height), needed = in_core_bytes(texels, pixel_bytes(plan));
    if (!told && needed <= large.ceiling()) return std::optional<MemoryPlan>();
    const Result<void> output = check_output(plan, texels * pixel_bytes(plan));
    if (!told && (!lacks.empty() || !output)) {
        if (!large.memory) return std::optional<MemoryPlan>();
        return fail(ErrorCode::budget, plan.given.input + ": needs " + std::to_string(needed >> 20) + " MiB in core, and --memory allows " + std::to_string(large.ceiling() >> 20) +
                                           " MiB; out of core " + (lacks.empty() ? output.error().message : lacks + " cannot be had"));
    }
    if (!output) return tl::unexpected(output.error());
    return check_rows(plan, sides->height)
        .and_then([&] { return plan_memory(sides->width, sides->height, pixel_bytes(plan), large.ceiling(), plan.given.input.c_str()); })
        .map([](const MemoryPlan& memory) { return std::optional<MemoryPlan>(memory); });
}

} // namespace reliefbake

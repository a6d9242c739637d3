#include "cli/verify/verify_bump.h"

#include "cli/report/format_text.h"
#include "formats/map_file.h"

namespace reliefbake {

namespace {

double percent(std::uint64_t part, std::uint64_t whole) { return whole > 0 ? 100 * double(part) / double(whole) : 0; }

} // namespace

Result<void> take_depth(BumpMap& map, const std::string& file, const std::string& relief, std::uint64_t max_bytes) {
    if (!map.depth.empty()) {
        if (relief.empty()) return {};
        return fail(ErrorCode::usage, file + ": --relief is for maps without depth; this one needs none");
    }
    if (relief.empty()) return fail(ErrorCode::usage, file + ": holds horizons alone; add --relief FILE, a cone map of the same heights");
    MapHints hints;
    hints.max_bytes = max_bytes;
    Result<ReliefMap> read = read_map(relief, hints);
    if (!read) return tl::unexpected(read.error());
    const bool known = !map.info.source_hash.empty() && !read->info.source_hash.empty();
    if (read->grid != map.grid || read->info.bits != map.info.bits || (known && read->info.source_hash != map.info.source_hash))
        return fail(ErrorCode::bad_data, relief + ": is not of the heights that the horizons were baked from: size, wrap, pixel aspect, bits and source must be the same");
    map.depth = std::move(read->depth);
    return {};
}

std::string verify_bump_text(const BumpMap& map, const BumpReport& report) {
    std::string text;
    if (!report.shadows.empty()) text = "sun                  pixels   dark %   wrong %: horizons (leaks, extra)   march of 64 steps\n";
    for (const ShadowReport& s : report.shadows)
        text += format("%5.1f deg, %2.0f high %9llu %8.2f %17.3f (%.3f, %.3f) %16.3f\n", s.azimuth, s.elevation,
                       static_cast<unsigned long long>(s.horizons.pixels), percent(s.horizons.dark, s.horizons.pixels), 100 * s.horizons.disagreement(),
                       percent(s.horizons.leaks, s.horizons.pixels), percent(s.horizons.extra, s.horizons.pixels), 100 * s.march.disagreement());
    text += format("values: %llu of %llu err by more than %.4g; the worst by %.4g, plane %d at texel %d, %d\n",
                   static_cast<unsigned long long>(report.violations), static_cast<unsigned long long>(report.points), report.bound, report.worst,
                   report.plane, report.x, report.y);
    if (map.info.kind == BumpKind::horizon && (map.grid.wrap_x == Wrap::repeat || map.grid.wrap_y == Wrap::repeat))
        text += format("horizons were asked for within %.0f texture widths\n", farthest_horizon);
    return text + "verdict: " + (report.violations == 0 ? "holds" : "violated") + "\n";
}

} // namespace reliefbake

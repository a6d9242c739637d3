#include "shaders-reference/measure/check_bump.h"

#include "bake/parallel.h"
#include "shaders-reference/measure/random.h"
#include "shaders-reference/oracle/texel_horizon.h"
#include "shaders-reference/renderer/relief_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reliefbake {
namespace {

/// The depth as the renderer takes it, without cones: followed exactly, by maximum mipmaps.
ReliefMap bare_relief(const BumpMap& map) {
    ReliefMap relief;
    relief.info.bits = map.info.bits;
    relief.info.depth_scale = map.info.depth_scale;
    relief.info.normal_y = map.info.normal_y;
    relief.grid = map.grid;
    relief.depth = map.depth;
    return relief;
}

/// Codes as they were, whatever a float made of code / largest code.
DepthMap depth_of(const BumpMap& map) {
    DepthMap depth{map.grid, map.info.bits, map.depth};
    if (is_unorm(map.info.bits))
        for (float& level : depth.level) level = std::round(level * float(max_code(map.info.bits)));
    return depth;
}

/// dH per texel at (x, y) by the definition of the kernel, along an axis: dx or dy is 1.
double difference(const BilinearSurface& surface, DerivativeKernel kernel, int x, int y, int dx, int dy) {
    const TexelGrid& grid = surface.grid();
    const int count = dx ? grid.width : grid.height, at = dx ? x : y;
    const bool clamps = (dx ? grid.wrap_x : grid.wrap_y) == Wrap::clamp;
    const int apart = clamps ? (at > 0) + (at < count - 1) : 2;
    if (apart == 0) return 0;
    const double weights[3][2] = {{1, 0}, {0.5, 0.25}, {0.625, 0.1875}};
    const auto across = [&](int k) { return surface.texel(x + dx + k * dy, y + dy + k * dx) - surface.texel(x - dx + k * dy, y - dy + k * dx); };
    const double* w = weights[int(kernel)];
    return (w[0] * across(0) + w[1] * (across(-1) + across(1))) / apart;
}

/// The exact values at a texel, in the order of the planes.
std::array<double, 3> exact_values(const BumpMapInfo& info, const BilinearSurface& surface, int x, int y) {
    const TexelGrid& grid = surface.grid();
    const double du = difference(surface, info.kernel, x, y, 1, 0) * grid.width, dv = difference(surface, info.kernel, x, y, 0, 1) * grid.height;
    if (info.kind == BumpKind::derivative) return {du, dv, 0};
    const double nx = -info.depth_scale * du, down = -info.depth_scale * dv / grid.aspect(), length = std::sqrt(nx * nx + down * down + 1);
    return {nx / length, (info.normal_y == NormalY::gl ? -down : down) / length, 1 / length};
}

void note(BumpReport& report, double error, int plane, int x, int y) {
    ++report.points;
    report.violations += !(error <= report.bound);
    if (error > report.worst) report.worst = error, report.plane = plane, report.x = x, report.y = y;
}

BumpReport joined(const std::vector<BumpReport>& parts) {
    BumpReport total = parts.front();
    for (std::size_t k = 1; k < parts.size(); ++k) {
        const std::uint64_t points = total.points + parts[k].points, violations = total.violations + parts[k].violations;
        if (parts[k].worst > total.worst) total = parts[k];
        total.points = points, total.violations = violations;
    }
    return total;
}

BumpReport check_texels(const BumpMap& map, const BilinearSurface& surface, int threads) {
    std::vector<BumpReport> rows(std::size_t(map.grid.height));
    parallel_for(map.grid.height, threads, [&](int y) {
        BumpReport& row = rows[std::size_t(y)];
        row.bound = map.info.error;
        for (int x = 0; x < map.grid.width; ++x) {
            const std::array<double, 3> exact = exact_values(map.info, surface, x, y);
            for (std::size_t plane = 0; plane < map.planes.size(); ++plane)
                note(row, std::fabs(decode_bump(map.planes[plane](x, y), map.info) - exact[plane]), int(plane), x, y);
        }
    });
    return joined(rows);
}

/// How far a stored sine is from what the oracle sees; where it must stop looking, from all that it may have overlooked.
double horizon_distance(const BumpMap& map, const BilinearSurface& surface, int plane, int x, int y) {
    const bool repeats = map.grid.wrap_x == Wrap::repeat || map.grid.wrap_y == Wrap::repeat;
    // Beyond the farther of its borders a clamped map is level; no azimuth runs slower than 1/2.24 towards either.
    const double far = repeats ? farthest_horizon : 2.5 * (1 + map.grid.aspect());
    const double scale = map.info.depth_scale;
    const auto sine = [scale](double slope) { return scale * slope / std::sqrt(1 + scale * scale * slope * slope); };
    const double slope = texel_horizon(surface, x, y, Heading::from_angle(horizon_angle(map.grid, plane)), far);
    const double overlooked = repeats ? (surface.highest() - surface.texel(x, y)) / far : 0;
    const double stored = decode_bump(map.planes[std::size_t(plane)](x, y), map.info);
    return std::max(sine(slope) - stored, stored - sine(std::max(slope, overlooked)));
}

BumpReport check_horizons(const BumpMap& map, const BilinearSurface& surface, const BumpCheckOptions& options) {
    constexpr int chunk_points = 256;
    std::vector<BumpReport> chunks(std::size_t(std::max(1, (options.points + chunk_points - 1) / chunk_points)));
    parallel_for(int(chunks.size()), options.threads, [&](int chunk) {
        SplitMix random(SplitMix(options.seed + std::uint64_t(chunk) * 0x9e3779b97f4a7c15u).next());
        BumpReport& report = chunks[std::size_t(chunk)];
        report.bound = map.info.error;
        for (int n = chunk * chunk_points; n < std::min(options.points, (chunk + 1) * chunk_points); ++n) {
            const int x = random.below(map.grid.width), y = random.below(map.grid.height), plane = random.below(horizon_azimuths);
            note(report, std::max(0.0, horizon_distance(map, surface, plane, x, y)), plane, x, y);
        }
    });
    return joined(chunks);
}

/// Suns on an azimuth, between two, and elsewhere; low ones draw long shadows.
Result<std::vector<ShadowReport>> check_shadows(const BumpMap& map, const BilinearSurface& surface, const BumpCheckOptions& options) {
    Result<ReliefRenderer> renderer = ReliefRenderer::create(options.backend);
    if (!renderer) return tl::unexpected<Error>(renderer.error());
    Result<void> loaded = renderer->load(bare_relief(map)).and_then([&] { return renderer->load_horizons(map); });
    if (!loaded) return tl::unexpected<Error>(loaded.error());
    std::vector<ShadowReport> reports;
    for (const double elevation : {10.0, 20.0, 40.0})
        for (const double azimuth : {90.0, 112.5, 225.0, 350.0}) {
            RenderOptions drawing;
            drawing.technique = Technique::max_mip;
            drawing.ambient = Ambient::none;
            drawing.width = drawing.height = std::max(8, int(std::sqrt(options.rays / 12.0)));
            drawing.view.angle = 0;
            drawing.sun = {azimuth, elevation};
            ShadowReport report{azimuth, elevation, {}, {}};
            for (const auto& [shadow, result] : {std::pair(Shadow::horizon, &report.horizons), std::pair(Shadow::hard, &report.march)}) {
                drawing.shadow = shadow;
                const Result<Rendering> rendering = renderer->render(drawing);
                if (!rendering) return tl::unexpected<Error>(rendering.error());
                *result = compare_shadows(surface, *rendering, sun_direction(drawing.sun, drawing.view), map.info.depth_scale, options.threads);
            }
            reports.push_back(report);
        }
    return reports;
}

nlohmann::json shadow_json(const ShadowComparison& shadow) {
    const auto share = [&](std::uint64_t part) { return shadow.pixels > 0 ? double(part) / double(shadow.pixels) : 0; };
    return {{"disagreement", shadow.disagreement()}, {"leaks", share(shadow.leaks)}, {"extra", share(shadow.extra)}};
}

} // namespace

Result<BumpReport> verify_bump(const BumpMap& map, const BumpCheckOptions& options) {
    const BilinearSurface surface(depth_of(map));
    if (map.info.kind != BumpKind::horizon) return check_texels(map, surface, options.threads);
    BumpReport report = check_horizons(map, surface, options);
    Result<std::vector<ShadowReport>> shadows = check_shadows(map, surface, options);
    if (!shadows) return tl::unexpected<Error>(shadows.error());
    report.shadows = std::move(*shadows);
    return report;
}

nlohmann::json to_json(const BumpReport& report) {
    nlohmann::json json = {
        {"verdict", report.violations == 0 ? "holds" : "violated"},
        {"points", report.points},
        {"violations", report.violations},
        {"bound", report.bound},
        {"worst", {{"error", report.worst}, {"plane", report.plane}, {"x", report.x}, {"y", report.y}}},
        {"shadows", nullptr},
    };
    if (!report.shadows.empty()) json["shadows"] = nlohmann::json::array();
    for (const ShadowReport& shadow : report.shadows)
        json["shadows"].push_back({{"sun_azimuth", shadow.azimuth},
                                   {"sun_elevation", shadow.elevation},
                                   {"pixels", shadow.horizons.pixels},
                                   {"dark", shadow.horizons.pixels > 0 ? double(shadow.horizons.dark) / double(shadow.horizons.pixels) : 0},
                                   {"horizons", shadow_json(shadow.horizons)},
                                   {"march", shadow_json(shadow.march)}});
    return json;
}

} // namespace reliefbake

#include "shaders-reference/measure/verify_shape.h"

#include "shaders-reference/measure/heat_map.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double narrow_field = 12; ///< degrees: every ray of a view has nearly the view's angle
constexpr double least_margin = 0.9; ///< of the distances that a map with f < 1 knows
constexpr std::size_t pictured = 1; ///< the view of which pictures are kept

struct ViewAngle {
    double angle, azimuth;
};
/// From above; along the lattice hardly ever: a ray beside a wall for a long way costs the oracle much and shows nothing more.
constexpr ViewAngle plane_views[] = {{0, 0}, {50, 25}, {75, 117}, {88, 229}};
/// Along the axis, from above, level, from below.
constexpr ViewAngle box_views[] = {{0, 0}, {60, 25}, {90, 117}, {130, 229}};

/// Every kind of solid: basic, extended, bevelled, chamfered; on a plane, in a box, revolved.
std::vector<SolidReport> all_solids(const ShapeMap& map, const ShapeVerifyOptions& options) {
    const double reach = options.outward + options.bevel;
    const bool bounded = map.info.scale_f < 1 || is_empty(map);
    const double share = bounded && reach > 0 ? std::min(1.0, least_margin * map.info.tau / reach) : 1;
    struct Growth {
        const char* name;
        double e, b, c;
    };
    const double e = share * options.outward, b = share * options.bevel, none = std::numeric_limits<double>::infinity();
    const Growth growths[] = {{"basic", 0, 0, none}, {"extended", e, 0, none}, {"bevelled", 0, b, none}, {"chamfered", e, b, options.chamfer}};
    struct Place {
        const char *kind, *name;
        SolidKind solid;
        bool on_plane;
    };
    const Place places[] = {{"extrusion", "plane", SolidKind::extrusion, true}, {"extrusion", "box", SolidKind::extrusion, false}, {"revolution", "box", SolidKind::revolution, false}};
    std::vector<SolidReport> solids;
    for (const Place& place : places)
        for (const Growth& growth : growths) {
            SolidReport solid;
            solid.name = std::string(place.kind) + ", " + growth.name + ", " + place.name;
            solid.solid = {place.solid, growth.e, growth.b, growth.c, options.axis, options.depth_scale, 1, place.on_plane};
            solids.push_back(std::move(solid));
        }
    return solids;
}

ShapeRenderOptions frame(const ShapeSolid& solid, const ViewAngle& view, int rays, const ShapeVerifyOptions& options) {
    ShapeRenderOptions result;
    result.solid = solid;
    result.scheme = options.scheme;
    result.steps = options.steps;
    result.binary_steps = options.binary_steps;
    result.projection = solid.kind == SolidKind::extrusion ? Projection::planar : Projection::cylindrical;
    // A plane seen at a grazing angle is a strip.
    const double aspect = solid.on_plane ? std::min(20.0, 1 / std::max(0.05, std::cos(view.angle * 3.14159265358979 / 180))) : 1;
    result.width = std::max(8, int(std::lround(std::sqrt(rays * aspect))));
    result.height = std::max(8, int(std::lround(std::sqrt(rays / aspect))));
    result.view = {view.angle, view.azimuth, narrow_field, 0};
    return result;
}

RgbImage error_picture(const ShapeRendering& rendering, const Image<Quad>& oracle, double scale) {
    RgbImage picture{rendering.width(), rendering.height(), {}};
    for (std::size_t k = 0; k < rendering.counts.size(); ++k) {
        std::array<std::uint8_t, 3> colour{};
        if (rendering.status(k) != RayStatus::no_ray) colour = viridis(std::abs(double(rendering.counts[k][3]) - double(oracle[k][0])) / scale);
        picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
    }
    return picture;
}

RgbImage steps_picture(const ShapeRendering& rendering, double brightest) {
    RgbImage picture{rendering.width(), rendering.height(), {}};
    for (std::size_t k = 0; k < rendering.counts.size(); ++k) {
        std::array<std::uint8_t, 3> colour{};
        if (rendering.status(k) != RayStatus::no_ray) colour = viridis(rendering.counts[k][0] / brightest);
        picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
    }
    return picture;
}

/// The frame again with the oracle's hits, and what differs: error to ten texels, steps to 64.
Result<ViewPictures> pictures_of(ShapeRenderer& renderer, const PixelShape& shape, ShapeRenderOptions drawing, const ShapeRendering& rendering, int threads) {
    const Image<Quad> hits = oracle_solid_hits(shape, drawing.solid, rendering, threads);
    drawing.scheme = CircleScheme::given;
    drawing.given = &hits;
    Result<ShapeRendering> truth = renderer.render(drawing);
    if (!truth) return tl::unexpected<Error>(truth.error());
    return ViewPictures{rendering.colour, std::move(truth->colour), error_picture(rendering, hits, 10 * shape.grid().pitch_x()), steps_picture(rendering, 64)};
}

Result<void> judge_solid(ShapeRenderer& renderer, const PixelShape& shape, SolidReport& report, int rays, const ShapeVerifyOptions& options, double allowed) {
    std::vector<ShapeRendering> views;
    for (const ViewAngle& view : report.solid.on_plane ? plane_views : box_views) {
        const ShapeRenderOptions drawing = frame(report.solid, view, rays / int(std::size(box_views)), options);
        Result<ShapeRendering> rendering = renderer.render(drawing);
        if (!rendering) return tl::unexpected<Error>(rendering.error());
        report.milliseconds += 1000 * rendering->seconds;
        views.push_back(std::move(*rendering));
        if (!options.pictures || views.size() != pictured + 1) continue;
        Result<ViewPictures> pictures = pictures_of(renderer, shape, drawing, views.back(), options.threads);
        if (!pictures) return tl::unexpected<Error>(pictures.error());
        report.pictures = std::move(*pictures);
    }
    report.comparison = compare_solid(shape, report.solid, views, {allowed, options.threads});
    return {};
}

} // namespace

Result<ShapeVerifyReport> verify_shape(const ShapeMap& map, const ShapeVerifyOptions& options) {
    Result<ShapeRenderer> renderer = ShapeRenderer::create(options.backend);
    if (!renderer) return tl::unexpected<Error>(renderer.error());
    if (Result<void> loaded = renderer->load(map, options.filter); !loaded) return tl::unexpected<Error>(loaded.error());

    ShapeVerifyReport report;
    const PixelShape shape = stored_shape(map);
    report.distances = check_distances(map, shape, options.points, options.seed, options.threads);
    report.allowed_gap = allowed_gap(map, options.filter, ShapeRenderOptions().epsilon);
    report.solids = all_solids(map, options);

    std::uint64_t rays = 0, missed = 0;
    const auto start = std::chrono::steady_clock::now();
    double drawn = 0;
    for (SolidReport& solid : report.solids) {
        Result<void> judged = judge_solid(*renderer, shape, solid, options.rays / int(report.solids.size()), options, report.allowed_gap);
        if (!judged) return tl::unexpected<Error>(judged.error());
        rays += solid.comparison.rays;
        missed += solid.comparison.missed + solid.comparison.not_finite;
        drawn += solid.milliseconds / 1000;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() - drawn;
    report.oracle_rays_per_second = seconds > 0 ? double(rays) / seconds : 0;
    const bool promised = map.info.guarantee == "S" && options.scheme == CircleScheme::corrected;
    if (missed + report.distances.violations > 0) report.verdict = promised ? Verdict::unsafe : Verdict::not_conservative;
    return report;
}

} // namespace reliefbake

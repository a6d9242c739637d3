#include "shaders-reference/measure/compare_solid.h"
#include "tests/support/fields.h"
#include "tests/support/glslang_check.h"
#include "tests/support/shapes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

const TexelGrid clamped24{24, 24, Wrap::clamp, Wrap::clamp, 1};

ShapeRenderer& renderer() {
    static ShapeRenderer made = *ShapeRenderer::create(RendererBackend::osmesa);
    return made;
}

ShapeRenderOptions frame(SolidKind kind, double angle, double azimuth, double e = 0, double b = 0, double c = INFINITY) {
    ShapeRenderOptions options;
    options.solid.kind = kind;
    options.solid.outward = e, options.solid.bevel = b, options.solid.chamfer = c;
    options.solid.depth_scale = 0.3;
    options.projection = kind == SolidKind::extrusion ? Projection::planar : Projection::cylindrical;
    options.steps = 1000, options.binary_steps = 16;
    options.width = 73, options.height = 57; // odd: the middle ray of a view from above runs along the axis
    options.view = {angle, azimuth, 20, 0};
    return options;
}

ShapeRendering draw(const ShapeMap& map, const ShapeRenderOptions& options) {
    REQUIRE(renderer().load(map));
    Result<ShapeRendering> rendering = renderer().render(options);
    if (!rendering) FAIL(rendering.error().message);
    return std::move(*rendering);
}

SolidComparison compare(const ShapeMap& map, const ShapeRenderOptions& options) {
    const ShapeRendering rendering = draw(map, options);
    return compare_solid(stored_shape(map), options.solid, {&rendering, 1}, {allowed_gap(map, SamplerFilter::exact, options.epsilon), 0});
}

struct Growth {
    double e, b, c;
};
/// Basic, extended, bevelled, chamfered.
constexpr Growth growths[] = {{0, 0, INFINITY}, {0.06, 0, INFINITY}, {0, 0.2, INFINITY}, {0.02, 0.2, 0.5}};

} // namespace

TEST_CASE("every shader of solids is valid under all three preludes", "[shaders][solid]") {
    GlslangCheck check;
    for (const Prelude prelude : {Prelude::core330, Prelude::core450, Prelude::es300})
        for (const CircleScheme scheme : {CircleScheme::corrected, CircleScheme::published, CircleScheme::given})
            for (const Projection projection : {Projection::planar, Projection::cylindrical, Projection::spherical})
                for (int bits = 0; bits < 16; ++bits) {
                    SolidConfig config;
                    config.kind = projection == Projection::planar ? SolidKind::extrusion : SolidKind::revolution;
                    config.scheme = scheme, config.projection = projection;
                    config.on_plane = bits & 1 && projection == Projection::planar;
                    config.unorm = bits & 2, config.signed_distance = bits & 4;
                    config.colour = config.shadow = config.bump = bits & 8;
                    check.add(solid_fragment_source(config, prelude), ".frag");
                }
    CHECK(check.faults() == "");
}

TEST_CASE("no ray misses a solid, in any kind, place, view and bit depth", "[renderer][solid]") {
    std::mt19937 random(1);
    std::uint64_t hits = 0, passed = 0;
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32})
        for (const Wrap wrap : {Wrap::clamp, Wrap::repeat})
            for (const bool with_sign : {false, true}) {
                const TexelGrid grid{20 + int(random() % 9), 17 + int(random() % 9), wrap, wrap, 1};
                ShapeMapOptions bake;
                bake.bits = bits, bake.signed_distance = with_sign;
                const ShapeMap squares = shape_map_of(grid, random_shape(grid, random(), 10), bake);
                const ShapeMap contour = contour_map_of(grid, random_coverage(grid, random(), 10), bake);
                for (const Growth& g : growths)
                    for (int place = 0; place < 6; ++place) {
                        const ShapeMap& map = place < 3 ? squares : contour;
                        const SolidKind kind = place % 3 == 2 ? SolidKind::revolution : SolidKind::extrusion;
                        ShapeRenderOptions options = frame(kind, place % 3 == 0 ? uniform(random, 0, 88) : uniform(random, 0, 180), uniform(random, 0, 360), g.e, g.b, g.c);
                        options.solid.on_plane = place % 3 == 0;
                        options.solid.tiles = wrap == Wrap::repeat ? 2 : 1;
                        options.solid.axis = random() % 2 * 0.4;
                        const SolidComparison result = compare(map, options);
                        INFO("bits " << int(bits) << " wrap " << int(wrap) << " place " << place << " e " << g.e << " b " << g.b << " c " << g.c << " angle "
                                     << options.view.angle << " azimuth " << options.view.azimuth << " gap max " << result.gap_max * grid.width);
                        CHECK(result.rays > 50); // planes seen at a grazing angle are strips
                        CHECK(result.missed == 0);
                        CHECK(result.early == 0);
                        CHECK(result.out_of_steps == 0);
                        CHECK(result.not_finite == 0);
                        hits += result.hits, passed += result.rays - result.hits;
                    }
            }
    CHECK(hits > 40000);
    CHECK(passed > 40000);
}

TEST_CASE("distances that are too long, or too short, are caught", "[renderer][solid]") {
    const TexelGrid grid = clamped24;
    for (ShapeMap map : {shape_map_of(grid, random_shape(grid, 5, 10)), contour_map_of(grid, random_coverage(grid, 5, 10))}) {
        const double tau = map.info.tau;
        std::uint64_t missed = 0, early = 0;
        for (const Growth& g : growths)
            for (const SolidKind kind : {SolidKind::extrusion, SolidKind::revolution}) {
                map.info.tau = 1.3 * tau;
                missed += compare(map, frame(kind, 70, 30, g.e, g.b, g.c)).missed;
                map.info.tau = 0.3 * tau;
                early += compare(map, frame(kind, 70, 30, g.e, g.b, g.c)).early;
            }
        INFO("model " << int(map.info.model));
        CHECK(missed > 100);
        CHECK(early > 100);
    }
}

TEST_CASE("an anti-aliased shape that is a little more than its map says is missed", "[renderer][solid]") {
    // A disc drawn from the map of one that is a third of a texel smaller.
    const auto coverage = [](double radius) {
        Image<float> disc(24, 24);
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 24; ++i) disc(i, j) = float(std::clamp(radius - std::hypot(i - 11.3, j - 11.9) + 0.5, 0.0, 1.0));
        return disc;
    };
    ShapeMapOptions bake;
    bake.bits = BitDepth::float32;
    const ShapeMap small = contour_map_of(clamped24, coverage(6.0), bake), large = contour_map_of(clamped24, coverage(6.35), bake);
    for (const SolidKind kind : {SolidKind::extrusion, SolidKind::revolution}) {
        const ShapeRenderOptions options = frame(kind, 70, 30, 0.1);
        CHECK(compare(small, options).missed == 0);
        const ShapeRendering rendering = draw(small, options);
        CHECK(compare_solid(stored_shape(large), options.solid, {&rendering, 1}, {1, 0}).missed > 20);
    }
}

TEST_CASE("the printed scheme jumps bevelled walls, the corrected one does not", "[renderer][solid]") {
    const TexelGrid grid = clamped24;
    const ShapeMap map = shape_map_of(grid, random_shape(grid, 6, 8));
    std::uint64_t missed = 0;
    for (const double azimuth : {10.0, 100.0, 220.0}) {
        ShapeRenderOptions options = frame(SolidKind::extrusion, 60, azimuth, 0, 0.4);
        options.solid.on_plane = true;
        CHECK(compare(map, options).missed == 0);
        options.scheme = CircleScheme::published;
        missed += compare(map, options).missed;
    }
    CHECK(missed > 0);
}

TEST_CASE("extremes are drawn without NaN and without a miss", "[renderer][solid]") {
    const auto one = [](int i, int j) { return i == 12 && j == 12; };
    const auto gap = [&](int i, int j) { return !one(i, j); };
    const auto border = [](int i, int j) { return i == 0 || j == 0 || i == 23 || j == 23; };
    const auto diagonal = [](int i, int j) { return i == j; };
    const auto column = [](int i, int) { return i == 0; };
    const auto none = [](int, int) { return false; };
    const auto all = [](int, int) { return true; };
    const std::pair<const char*, std::function<bool(int, int)>> shapes[] = {{"one", one},       {"gap", gap},   {"border", border}, {"diagonal", diagonal},
                                                                            {"column", column}, {"none", none}, {"all", all}};
    const Growth extremes[] = {{0, 0, 0}, {0, 0.3, 0}, {0, 0.3, 1}, {0, 1e6, INFINITY}, {0, 1e6, 0}, {5, 0, INFINITY}, {0, 0, INFINITY}};
    for (const auto& [name, inside] : shapes) {
        const ShapeMap map = shape_map_of(clamped24, shape_of(clamped24, inside));
        for (const Growth& g : extremes) {
            if (name == std::string("none") && (g.e > 1 || g.b * g.c > 1)) continue; // refused: see below
            for (const SolidKind kind : {SolidKind::extrusion, SolidKind::revolution})
                // Straight down (revolution: along the axis), grazing, level, and up from below.
                for (const double angle : {0.0, 89.9, 90.0, 180.0})
                    for (const double azimuth : {0.0, 90.0}) {
                        const ShapeRenderOptions options = frame(kind, angle, azimuth, g.e, g.b, g.c);
                        const SolidComparison result = compare(map, options);
                        INFO(name << " kind " << int(kind) << " e " << g.e << " b " << g.b << " c " << g.c << " angle " << angle << " azimuth " << azimuth);
                        CHECK(result.not_finite == 0);
                        CHECK(result.missed == 0);
                        CHECK(result.early == 0);
                        CHECK(result.rays > 0);
                        if (name == std::string("none")) CHECK(result.hits == 0);
                        if (name == std::string("all")) CHECK(result.hits == result.rays);
                    }
        }
    }
}

TEST_CASE("depth is written where the solid is, and nothing beside it", "[renderer][solid]") {
    const ShapeMap map = shape_map_of(clamped24, shape_of(clamped24, [](int i, int j) { return std::hypot(i - 11.5, j - 11.5) < 6; }));
    for (const SolidKind kind : {SolidKind::extrusion, SolidKind::revolution}) {
        const ShapeRendering rendering = draw(map, frame(kind, 50, 20));
        std::size_t drawn = 0;
        for (std::size_t k = 0; k < rendering.counts.size(); ++k) {
            CHECK((rendering.depth[k] < 1) == (rendering.status(k) == RayStatus::hit));
            drawn += rendering.depth[k] < 1;
        }
        CHECK(drawn > 200);
        CHECK(drawn < rendering.counts.size() / 2);
    }
}

TEST_CASE("shader normals of smooth solids are those of the oracle", "[renderer][solid]") {
    const TexelGrid grid{256, 256, Wrap::clamp, Wrap::clamp, 1};
    const ShapeMap map = shape_map_of(grid, shape_of(grid, [](int i, int j) { return std::hypot(i - 90.0, j - 128.0) < 50; }), {DistanceMethod::exact, false, 1, BitDepth::unorm16, 0});
    for (const Growth& g : {Growth{0.1, 0, INFINITY}, Growth{0.1, 0.1, INFINITY}, Growth{0.1, 0.2, 0.5}})
        for (const SolidKind kind : {SolidKind::extrusion, SolidKind::revolution}) {
            const SolidComparison result = compare(map, frame(kind, 60, 30, g.e, g.b, g.c));
            INFO("kind " << int(kind) << " b " << g.b << " c " << g.c);
            CHECK(result.hits > 300);
            CHECK(result.normal_mean < 1.5);
        }
}

TEST_CASE("solids that the map cannot show are refused", "[renderer][solid]") {
    ShapeMapOptions bake;
    bake.scale_f = 0.3;
    const ShapeMap map = shape_map_of(clamped24, random_shape(clamped24, 5, 10), bake);
    REQUIRE(renderer().load(map));
    const auto refused = [&](auto change) {
        ShapeRenderOptions options = frame(SolidKind::extrusion, 30, 0);
        change(options);
        const Result<ShapeRendering> rendering = renderer().render(options);
        return !rendering && rendering.error().code == ErrorCode::usage;
    };
    CHECK_FALSE(refused([](ShapeRenderOptions&) {}));
    CHECK(refused([](ShapeRenderOptions& o) { o.solid.outward = 0.9; })); // beyond tau
    CHECK(refused([](ShapeRenderOptions& o) { o.solid.outward = -1; }));
    CHECK(refused([](ShapeRenderOptions& o) { o.solid.bevel = NAN; }));
    CHECK(refused([](ShapeRenderOptions& o) { o.solid.chamfer = -1; }));
    CHECK(refused([](ShapeRenderOptions& o) { o.solid.axis = 1; }));
    CHECK(refused([](ShapeRenderOptions& o) { o.solid.tiles = 2; }));
    CHECK(refused([](ShapeRenderOptions& o) { o.projection = Projection::spherical; }));
    REQUIRE(renderer().load(shape_map_of(clamped24, random_shape(clamped24, 1, 0))));
    CHECK_FALSE(refused([](ShapeRenderOptions& o) { o.solid.outward = 1; }));
    CHECK(refused([](ShapeRenderOptions& o) { o.solid.outward = 2; })); // as far as an empty shape is said to be
}

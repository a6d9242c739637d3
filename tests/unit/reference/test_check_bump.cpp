// Bump maps and their shadows, judged; mutations that must be caught.

#include "shaders-reference/measure/check_bump.h"
#include "shaders-reference/renderer/relief_renderer.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

BumpMap baked(const DepthMap& depth, BumpMapInfo info) {
    info.bits = depth.bits;
    switch (info.kind) {
    case BumpKind::derivative: {
        const DerivativeMap map = bake_derivatives(depth, info.kernel);
        info.derivative_scale = std::max(1e-9, largest_derivative(map));
        return encode_derivatives(info, depth, map);
    }
    case BumpKind::normal: return encode_normals(info, depth, bake_normals(depth, info.depth_scale, 1, info.kernel));
    case BumpKind::horizon: break;
    }
    info.layout = ChannelLayout::named;
    return encode_horizons(info, depth, bake_horizons(depth, info.depth_scale));
}

BumpCheckOptions quick() {
    BumpCheckOptions options;
    options.points = 3000;
    options.rays = 12 * 24 * 24;
    return options;
}

DepthMap with_bits(DepthMap depth, BitDepth bits) {
    for (float& level : depth.level) level = is_unorm(bits) ? level * float(max_code(bits) / 255) : std::round(level) / 256;
    depth.bits = bits;
    return depth;
}

/// A wall of height 1 across a flat map.
DepthMap wall() {
    return depth_of({64, 64, Wrap::clamp, Wrap::clamp, 1}, [](int i, int) { return i >= 32 && i < 36 ? 1.0 : 0.0; });
}

ShadowComparison shadows_of(const BumpMap& map, const Sun& sun) {
    ReliefMap relief;
    relief.info.bits = map.info.bits, relief.info.depth_scale = map.info.depth_scale;
    relief.grid = map.grid, relief.depth = map.depth;
    ReliefRenderer renderer = ReliefRenderer::create(RendererBackend::osmesa).value();
    REQUIRE(renderer.load(relief));
    REQUIRE(renderer.load_horizons(map));
    RenderOptions options;
    options.technique = Technique::max_mip, options.ambient = Ambient::none, options.shadow = Shadow::horizon;
    options.width = options.height = 160, options.view.angle = 0, options.sun = sun;
    const Rendering rendering = renderer.render(options).value();
    return compare_shadows(BilinearSurface({map.grid, map.info.bits, map.depth}), rendering, sun_direction(sun, options.view), map.info.depth_scale);
}

} // namespace

TEST_CASE("every kind of bump map keeps its stated error, in every bit depth") {
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32})
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
            for (const BumpKind kind : {BumpKind::derivative, BumpKind::normal, BumpKind::horizon})
                for (const DerivativeKernel kernel : {DerivativeKernel::central, DerivativeKernel::sobel, DerivativeKernel::scharr})
                    for (const SignedCodes codes : {SignedCodes::centred, SignedCodes::unorm}) {
                        if (kind == BumpKind::horizon && (kernel != DerivativeKernel::central || codes != SignedCodes::centred)) continue;
                        BumpMapInfo info;
                        info.kind = kind, info.kernel = kernel, info.codes = codes;
                        info.normal_y = kernel == DerivativeKernel::sobel ? NormalY::dx : NormalY::gl;
                        const DepthMap depth = with_bits(noise(grid_of(19, 13, wrap, 0.8), 3), bits);
                        const BumpReport report = verify_bump(baked(depth, info), quick()).value();
                        CAPTURE(int(bits), int(wrap), int(kind), int(kernel), int(codes), report.worst, report.bound, report.plane);
                        CHECK(report.violations == 0);
                        CHECK(report.points >= 494);
                        if (is_unorm(bits)) CHECK(report.worst > 0.5 * report.bound); // the bound is not idle
                    }
}

TEST_CASE("a value one code off, a swapped channel, another kernel and another depth scale are caught") {
    const DepthMap depth = with_bits(noise(grid_of(19, 13, Wrap::repeat), 7), BitDepth::unorm16);
    const auto violations = [](const BumpMap& map) { return verify_bump(map, quick()).value().violations; };
    for (const BumpKind kind : {BumpKind::derivative, BumpKind::normal, BumpKind::horizon}) {
        BumpMapInfo info;
        info.kind = kind;
        const BumpMap good = baked(depth, info);
        CAPTURE(int(kind));
        REQUIRE(violations(good) == 0);
        BumpMap bad = good;
        for (float& value : bad.planes[1]) value += value > 0.5f ? -1.01f / 65535 : 1.01f / 65535;
        CHECK(violations(bad) > 0);
        bad = good;
        std::swap(bad.planes[0], bad.planes[1]);
        CHECK(violations(bad) > 0);
        bad = good;
        bad.info.kernel = DerivativeKernel::sobel, bad.info.depth_scale *= 1.01;
        CHECK(violations(bad) > 0);
    }
}

TEST_CASE("a wall's shadow is as long as it is high, and the horizon map's is the exact one along an azimuth") {
    BumpMapInfo info;
    info.kind = BumpKind::horizon, info.depth_scale = 0.1;
    const BumpMap map = baked(wall(), info);
    // The sun stands over the right border; the wall is 0.1 high, and its left foot ends at 31.5 texels.
    for (const double elevation : {15.0, 25.0, 40.0}) {
        const ShadowComparison shadow = shadows_of(map, {90, elevation});
        const double length = std::min(0.1 / std::tan(elevation * 3.14159265358979 / 180), 31.5 / 64);
        CAPTURE(elevation);
        CHECK(double(shadow.dark) / double(shadow.pixels) == Approx(length).margin(0.02));
        CHECK(shadow.disagreement() < 0.015);
    }
    // From the other side the shadow falls to the right.
    CHECK(shadows_of(map, {270, 25}).disagreement() < 0.015);
    CHECK(shadows_of(map, {90, 89}).disagreement() < 0.1);
}

TEST_CASE("flat maps have no shadow, at any azimuth") {
    BumpMapInfo info;
    info.kind = BumpKind::horizon;
    const BumpMap map = baked(adversarial(grid_of(16, 16, Wrap::repeat), "constant"), info);
    for (const double azimuth : {0.0, 33.0, 45.0, 190.0, 301.0}) {
        const ShadowComparison shadow = shadows_of(map, {azimuth, 3});
        CHECK(shadow.dark == 0);
        CHECK(shadow.extra == 0);
    }
}

TEST_CASE("between azimuths the horizon is a mixture: of a cone-shaped pit it is the same all around") {
    // A round bowl's horizon at its middle is its rim's, in every direction.
    const TexelGrid grid{65, 65, Wrap::clamp, Wrap::clamp, 1};
    const DepthMap bowl = depth_of(grid, [](int i, int j) { return std::min(1.0, std::hypot(i - 32, j - 32) / 24.0); });
    BumpMapInfo info;
    info.kind = BumpKind::horizon, info.depth_scale = 0.2;
    const BumpMap map = baked(bowl, info);
    for (const double azimuth : {0.0, 20.0, 75.0, 160.0, 250.0, 333.0}) CHECK(shadows_of(map, {azimuth, 25}).disagreement() < 0.05);
}

TEST_CASE("horizons of other heights, kinds, wraps and no horizons at all are refused") {
    const DepthMap depth = noise(grid_of(8, 8, Wrap::repeat), 2);
    ReliefMap relief;
    relief.info.bits = depth.bits, relief.grid = depth.grid, relief.depth = depth.level;
    for (float& d : relief.depth) d /= 255;
    relief.info.source_hash = std::string("a");
    ReliefRenderer renderer = ReliefRenderer::create(RendererBackend::osmesa).value();
    REQUIRE(renderer.load(relief));
    RenderOptions options;
    options.technique = Technique::max_mip, options.shadow = Shadow::horizon, options.width = options.height = 16;
    CHECK_FALSE(renderer.render(options));
    BumpMapInfo info;
    info.kind = BumpKind::horizon;
    BumpMap map = baked(depth, info);
    map.info.source_hash = std::string("b");
    CHECK_FALSE(renderer.load_horizons(map));
    map.info.source_hash = std::string("a");
    map.grid.wrap_x = Wrap::clamp;
    CHECK_FALSE(renderer.load_horizons(map));
    map.grid = depth.grid;
    REQUIRE(renderer.load_horizons(map));
    CHECK(renderer.render(options));
    CHECK_FALSE(renderer.load_horizons(baked(depth, {})));
    REQUIRE(renderer.load(relief));
    CHECK_FALSE(renderer.render(options)); // forgotten with the next map
}

#include "shaders-reference/measure/compare.h"
#include "shaders-reference/measure/stored_depth.h"
#include "shaders-reference/renderer/relief_renderer.h"
#include "tests/support/fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

RenderOptions small_frame(double angle, double azimuth) {
    RenderOptions options;
    options.width = 160;
    options.height = 120;
    options.view.angle = angle;
    options.view.azimuth = azimuth;
    options.view.field_of_view = 12;
    options.max_steps = 1000;
    return options;
}

ReliefMap safe_map(const DepthMap& depth, ConeEncoding encoding, BitDepth bits = BitDepth::unorm16) {
    MapChoices choices;
    choices.encoding = encoding;
    choices.bits = bits;
    return make_relief_map(depth, proven_l2_cones(depth, 1), 1, choices);
}

Comparison compare(const ReliefMap& map, const RenderOptions& options, RendererBackend backend = RendererBackend::osmesa) {
    const Result<Rendering> rendering = render(map, options, backend);
    REQUIRE(rendering);
    return compare_with_oracle(BilinearSurface(stored_depth(map)), *rendering);
}

} // namespace

TEST_CASE("a conservative map misses nothing, in every encoding and view", "[renderer]") {
    const TexelGrid grids[] = {{16, 16, Wrap::repeat, Wrap::repeat, 1},
                               {16, 9, Wrap::repeat, Wrap::repeat, 1},
                               {7, 12, Wrap::clamp, Wrap::clamp, 0.7},
                               {12, 8, Wrap::repeat, Wrap::clamp, 1.3}};
    const ConeEncoding encodings[] = {ConeEncoding::ratio, ConeEncoding::sqrt, ConeEncoding::radius, ConeEncoding::normal};
    std::uint32_t seed = 1;
    for (const TexelGrid& grid : grids)
        for (const ConeEncoding encoding : encodings) {
            const ReliefMap map = safe_map(noise(grid, seed++), encoding);
            for (const bool exact : {false, true})
                for (const double angle : {0.0, 60.0, 85.0}) {
                    RenderOptions options = small_frame(angle, 20.0 * seed);
                    options.exact_finish = exact;
                    const Comparison result = compare(map, options);
                    INFO("grid " << grid.width << "x" << grid.height << " encoding " << int(encoding) << " exact " << exact
                                 << " angle " << angle);
                    CHECK(result.rays > 100);
                    CHECK(result.missed == 0);
                    if (exact) CHECK(result.early == 0);
                    if (exact) CHECK(result.mse < 1e-9);
                }
        }
}

TEST_CASE("codes of 0 do not stop a ray", "[renderer]") {
    const DepthMap depth = noise({16, 16, Wrap::repeat, Wrap::repeat, 1}, 3);
    const ReliefMap map = make_relief_map(depth, Image<float>(16, 16, 0), 1, {});
    const Comparison result = compare(map, small_frame(80, 30));
    CHECK(result.missed == 0);
    CHECK(result.early == 0);
    CHECK(result.out_of_steps == 0);
}

TEST_CASE("float maps and square cones march safely too", "[renderer]") {
    const DepthMap depth = noise({16, 12, Wrap::repeat, Wrap::repeat, 1}, 4);
    MapChoices choices;
    choices.metric = Metric::l1;
    choices.bits = BitDepth::float32;
    DepthMap floats = depth;
    floats.bits = BitDepth::float32;
    for (float& level : floats.level) level /= 255;
    const ReliefMap map = make_relief_map(floats, minimum_3x3(texel_cones(floats, Metric::l1, 1), floats.grid), 1, choices);
    for (const double azimuth : {0.0, 33.0, 45.0}) CHECK(compare(map, small_frame(75, azimuth)).missed == 0);
}

TEST_CASE("a linear search misses thin walls and cone stepping does not", "[renderer]") {
    const DepthMap walls = depth_of({32, 32, Wrap::repeat, Wrap::repeat, 1}, [](int i, int) { return i % 8 == 0 ? 1.0 : 0.0; });
    const ReliefMap map = make_relief_map(walls, proven_l2_cones(walls, 1), 1, {ConeEncoding::sqrt});
    RenderOptions options = small_frame(82, 70);
    CHECK(compare(map, options).missed == 0);
    options.technique = Technique::linear;
    options.linear_steps = 4;
    const Comparison linear = compare(map, options);
    CHECK(linear.missed > linear.rays / 50);
    options.technique = Technique::binary;
    options.linear_steps = 64;
    const Comparison binary = compare(map, options);
    CHECK(binary.mse < linear.mse);
}

TEST_CASE("the published step oversteps where the map is not square", "[renderer]") {
    // Steep rays along v on a map four times as wide as high: the printed scale is 4, more than the cone allows.
    const DepthMap depth = depth_of({32, 8, Wrap::repeat, Wrap::repeat, 1}, [](int i, int) { return i == 0 ? 1.0 : 0.5; });
    const ReliefMap map = make_relief_map(depth, proven_l2_cones(depth, 1), 1, {});
    RenderOptions options = small_frame(10, 0);
    CHECK(compare(map, options).missed == 0);
    options.technique = Technique::cone_published;
    CHECK(compare(map, options).missed > 0);
}

TEST_CASE("a flat relief is hit where the plane is", "[renderer]") {
    const DepthMap flat = depth_of({4, 4, Wrap::clamp, Wrap::clamp, 1}, [](int, int) { return 0.5; });
    const ReliefMap map = make_relief_map(flat, Image<float>(4, 4, 1), 1, {ConeEncoding::ratio, BitDepth::float32});
    RenderOptions options = small_frame(0, 0);
    options.exact_finish = true;
    const Result<Rendering> rendering = render(map, options);
    REQUIRE(rendering);
    // From above, the picture's centre looks at the map's centre, and up is up the image.
    const Quad& centre = rendering->hit(options.width / 2, options.height / 2);
    CHECK(centre[0] == Approx(0.5).margin(0.01));
    CHECK(centre[1] == Approx(0.5).margin(0.01));
    CHECK(centre[2] == Approx(0.5).margin(1e-6));
    CHECK(rendering->hit(options.width / 2, options.height / 4)[1] < 0.4f);
    CHECK(rendering->hit(3 * options.width / 4, options.height / 2)[0] > 0.6f);
    CHECK(rendering->depth(options.width / 2, options.height / 2) < 1);
    CHECK(rendering->depth(0, 0) == 1);
}

TEST_CASE("both backends draw the same frame", "[renderer]") {
    const ReliefMap map = safe_map(noise({16, 16, Wrap::repeat, Wrap::repeat, 1}, 8), ConeEncoding::sqrt);
    const Result<Rendering> egl = render(map, small_frame(60, 10), RendererBackend::egl);
    const Result<Rendering> osmesa = render(map, small_frame(60, 10), RendererBackend::osmesa);
    REQUIRE(egl);
    REQUIRE(osmesa);
    double worst = 0;
    for (std::size_t i = 0; i < egl->hit.size(); ++i)
        worst = std::max(worst, std::abs(double(egl->hit[i][2]) - double(osmesa->hit[i][2])));
    CHECK(worst < 1e-3);
}

TEST_CASE("given hits are shaded as they are", "[renderer]") {
    const ReliefMap map = safe_map(noise({16, 16, Wrap::repeat, Wrap::repeat, 1}, 9), ConeEncoding::sqrt);
    RenderOptions options = small_frame(50, 200);
    options.exact_finish = true;
    const Result<Rendering> marched = render(map, options);
    REQUIRE(marched);
    const Image<Quad> hits = oracle_hits(BilinearSurface(stored_depth(map)), *marched);
    options.technique = Technique::given;
    options.given = &hits;
    const Result<Rendering> given = render(map, options);
    REQUIRE(given);
    double difference = 0;
    for (std::size_t i = 0; i < given->colour.rgb.size(); ++i)
        difference += std::abs(int(given->colour.rgb[i]) - int(marched->colour.rgb[i]));
    CHECK(difference / double(given->colour.rgb.size()) < 0.05);
}

TEST_CASE("what the renderer cannot do is refused", "[renderer]") {
    const ReliefMap map = safe_map(noise({4, 4, Wrap::repeat, Wrap::repeat, 1}, 2), ConeEncoding::sqrt);
    RenderOptions options;
    options.width = 1 << 20;
    CHECK_FALSE(render(map, options));
    CHECK_FALSE(render(map, RenderOptions{}, RendererBackend::osmesa, SamplerFilter::fixed8));
}

// Guarantee C (MATHS section 2): the baked cone against slow truth that shares no code with the bake.

#include "bake/cone.h"
#include "tests/support/cone_fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

ConeOptions exact(SurfaceModel surface, Metric metric) {
    ConeOptions options;
    options.surface = surface;
    options.metric = metric;
    options.tolerance = 0;
    options.ratio_max = 4;
    options.threads = 1;
    return options;
}

/// Both maps' cones, texel by texel: never wider than `truth`, and at least `share` of it.
void require_between(const DepthMap& depth, const Image<float>& baked, const Image<float>& truth, double share) {
    for (int j = 0; j < depth.grid.height; ++j)
        for (int i = 0; i < depth.grid.width; ++i) {
            CAPTURE(depth.grid.width, depth.grid.height, depth.grid.wrap_x == Wrap::repeat, i, j);
            REQUIRE(double(baked(i, j)) <= double(truth(i, j)) * (1 + 1e-6));
            REQUIRE(double(baked(i, j)) >= double(truth(i, j)) * share);
        }
}

void check_all_models(const DepthMap& depth, bool dense) {
    const auto cones = [&](SurfaceModel s, Metric m) { return bake_cones(depth, exact(s, m)).ratio; };
    for (Metric metric : {Metric::l2, Metric::l1}) {
        const Image<float> texels = texel_cones(depth, metric, 4);
        require_between(depth, cones(SurfaceModel::texel, metric), texels, 1 - 3e-6);
        if (metric == Metric::l1)
            require_between(depth, cones(SurfaceModel::bilinear, metric), minimum_3x3(texels, depth.grid), 1 - 3e-6);
    }
    if (dense)
        require_between(depth, cones(SurfaceModel::bilinear, Metric::l2), footprint_cones(depth, 4, 3, 24), 0.75);
}

} // namespace

TEST_CASE("every size from 1x1 to 17x13: texel and L1 cones equal brute force, L2 cones stay below it") {
    std::uint32_t seed = 1;
    for (int height = 1; height <= 13; ++height)
        for (int width = 1; width <= 17; ++width)
            for (Wrap wrap : {Wrap::repeat, Wrap::clamp})
                check_all_models(noise(grid_of(width, height, wrap), ++seed), width * height <= 42);
}

TEST_CASE("fields larger than the near radius: the pyramid finds what brute force finds") {
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const std::string& name : adversarial_names()) {
            CAPTURE(name);
            check_all_models(adversarial(grid_of(53, 37, wrap), name), false);
            check_all_models(adversarial(grid_of(64, 1, wrap), name), true);
            check_all_models(adversarial(grid_of(1, 41, wrap), name), true);
        }
}

TEST_CASE("L2 cones of adversarial fields lie below the dense footprint cone") {
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const std::string& name : adversarial_names()) {
            CAPTURE(name);
            const DepthMap depth = adversarial(grid_of(24, 20, wrap), name);
            require_between(depth, bake_cones(depth, exact(SurfaceModel::bilinear, Metric::l2)).ratio,
                            footprint_cones(depth, 4, 3, 48), 0.85);
        }
}

TEST_CASE("texels that are not square keep the guarantee") {
    for (double aspect : {0.5, 0.8, 1.6, 2.0})
        for (const char* name : {"hill", "fine checkerboard", "stairs"}) {
            CAPTURE(aspect, name);
            const DepthMap depth = adversarial(grid_of(20, 18, Wrap::clamp, aspect), name);
            check_all_models(depth, true);
            check_all_models(noise(grid_of(9, 7, Wrap::repeat, aspect), 77), true);
        }
}

TEST_CASE("the tolerance only ever narrows cones, and by no more than it says") {
    for (float tolerance : {0.001f, 0.01f, 0.1f}) {
        const DepthMap depth = noise(grid_of(70, 45, Wrap::repeat), 5);
        ConeOptions options = exact(SurfaceModel::texel, Metric::l2);
        const Image<float> truth = bake_cones(depth, options).ratio;
        options.tolerance = tolerance;
        require_between(depth, bake_cones(depth, options).ratio, truth, (1 - 1e-6) / (1 + double(tolerance)));
    }
}

TEST_CASE("a spike far away gives distance over height") {
    const DepthMap depth = depth_of(grid_of(128, 128, Wrap::clamp), [](int i, int j) { return i == 100 && j == 64 ? 1.0 : 0.0; });
    const Image<float> ratio = bake_cones(depth, exact(SurfaceModel::texel, Metric::l2)).ratio;
    REQUIRE(ratio(10, 64) == Approx(90.0 / 128).epsilon(2e-6));
    REQUIRE(ratio(100, 4) == Approx(60.0 / 128).epsilon(2e-6));
}

TEST_CASE("denormal and tiny depths do not lose their cones") {
    for (float tiny : {1e-44f, 1e-39f, 1e-30f, 1e-12f, 1e-6f}) {
        CAPTURE(tiny);
        DepthMap depth{grid_of(12, 12, Wrap::clamp), BitDepth::float32, Image<float>(12, 12)};
        for (int j = 0; j < 12; ++j)
            for (int i = 0; i < 12; ++i) depth.level(i, j) = (i + j) % 2 ? tiny : 0.0f;
        ConeOptions options = exact(SurfaceModel::bilinear, Metric::l2);
        options.ratio_max = std::numeric_limits<float>::infinity();
        for (float r : bake_cones(depth, options).ratio) {
            REQUIRE(std::isfinite(r));
            REQUIRE(double(r) <= 1.0 / (12 * double(tiny)));
        }
    }
}

TEST_CASE("without a cap a flat field has unbounded cones, with one it has the cap") {
    for (BitDepth bits : {BitDepth::unorm8, BitDepth::float32}) {
        const DepthMap depth = adversarial(grid_of(40, 30, Wrap::repeat), "constant", bits);
        ConeOptions options;
        for (float r : bake_cones(depth, options).ratio) REQUIRE(r == Approx(1.0f).epsilon(1e-6));
        options.ratio_max = std::numeric_limits<float>::infinity();
        for (float r : bake_cones(depth, options).ratio) REQUIRE(std::isinf(r));
    }
}

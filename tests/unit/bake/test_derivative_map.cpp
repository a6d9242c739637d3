#include "bake/derivative_map.h"
#include "bake/normal_map.h"
#include "bake/signed_code.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr DerivativeKernel kernels[] = {DerivativeKernel::central, DerivativeKernel::sobel, DerivativeKernel::scharr};

/// Height levels out of 65535.
DepthMap field(const TexelGrid& grid, const std::function<int(int, int)>& height) {
    DepthMap map{grid, BitDepth::unorm16, Image<float>(grid.width, grid.height)};
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) map.level(i, j) = float(65535 - height(i, j));
    return map;
}

template <class Source>
DepthMap moved(const DepthMap& map, TexelGrid grid, Source source) {
    DepthMap result{grid, map.bits, Image<float>(grid.width, grid.height)};
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
            const auto [x, y] = source(i, j);
            result.level(i, j) = map.level(x, y);
        }
    return result;
}

} // namespace

TEST_CASE("Every kernel has the exact derivative of a plane, at clamped borders too") {
    const TexelGrid grid = grid_of(13, 7, Wrap::clamp, 0.8);
    const DepthMap plane = field(grid, [](int i, int j) { return 9000 + 1024 * i - 777 * j; });
    for (const DerivativeKernel kernel : kernels) {
        const DerivativeMap map = bake_derivatives(plane, kernel);
        for (std::size_t k = 0; k < map.du.size(); ++k) {
            REQUIRE(map.du[k] == float(1024 * 13 / 65535.0));
            REQUIRE(map.dv[k] == float(-777 * 7 / 65535.0));
        }
    }
}

TEST_CASE("A flat map has derivatives of exactly 0, whose code is that of zero") {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32})
            for (const DerivativeKernel kernel : kernels) {
                const DerivativeMap map = bake_derivatives(adversarial(grid_of(5, 4, wrap), "constant", bits), kernel);
                for (const Image<float>* plane : {&map.du, &map.dv})
                    for (const float value : *plane) {
                        REQUIRE((value == 0 && !std::signbit(value)));
                        if (is_unorm(bits)) REQUIRE(stored_signed(value, bits, SignedCodes::centred) == float(centred_zero(bits)) / float(max_code(bits)));
                    }
            }
}

TEST_CASE("Kernels weigh their rows as their names say") {
    // One texel of height 1 in a repeated map: its neighbours' derivatives are the kernel's weights.
    const TexelGrid grid = grid_of(8, 8, Wrap::repeat);
    const DepthMap spike = field(grid, [](int i, int j) { return i == 4 && j == 4 ? 65535 : 0; });
    const double weights[][2] = {{0, 1}, {0.25, 0.5}, {3 / 16.0, 10 / 16.0}};
    for (int kernel = 0; kernel < 3; ++kernel) {
        const DerivativeMap map = bake_derivatives(spike, kernels[kernel]);
        for (int across = -1; across <= 1; ++across) {
            const double expected = weights[kernel][across == 0] * 8 / 2;
            CHECK(map.du(3, 4 + across) == Approx(expected));
            CHECK(map.du(5, 4 + across) == Approx(-expected));
            CHECK(map.dv(4 + across, 3) == Approx(expected));
            CHECK(map.dv(4 + across, 5) == Approx(-expected));
        }
        CHECK(map.du(4, 4) == 0);
        CHECK(map.du(2, 4) == 0);
    }
}

TEST_CASE("Mirrored, transposed and shifted maps have mirrored, transposed and shifted derivatives, bit for bit") {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const DerivativeKernel kernel : kernels) {
            const TexelGrid grid = grid_of(11, 6, wrap), turned = grid_of(6, 11, wrap);
            const DepthMap depth = noise(grid, 3);
            const DerivativeMap map = bake_derivatives(depth, kernel);
            const DerivativeMap mirror = bake_derivatives(moved(depth, grid, [](int i, int j) { return std::pair(10 - i, j); }), kernel);
            const DerivativeMap transposed = bake_derivatives(moved(depth, turned, [](int i, int j) { return std::pair(j, i); }), kernel);
            const DerivativeMap shifted = bake_derivatives(moved(depth, grid, [](int i, int j) { return std::pair((i + 4) % 11, (j + 5) % 6); }), kernel);
            for (int j = 0; j < 6; ++j)
                for (int i = 0; i < 11; ++i) {
                    REQUIRE(mirror.du(10 - i, j) == -map.du(i, j));
                    REQUIRE(mirror.dv(10 - i, j) == map.dv(i, j));
                    REQUIRE(transposed.du(j, i) == map.dv(i, j));
                    REQUIRE(transposed.dv(j, i) == map.du(i, j));
                    if (wrap == Wrap::repeat) REQUIRE(shifted.du(i, j) == map.du((i + 4) % 11, (j + 5) % 6));
                    if (wrap == Wrap::repeat) REQUIRE(shifted.dv(i, j) == map.dv((i + 4) % 11, (j + 5) % 6));
                }
        }
}

TEST_CASE("The bump of 003 (4) and (5) with these derivatives is the normal map") {
    const TexelGrid grid = grid_of(12, 9, Wrap::repeat, 1.25);
    const DepthMap depth = noise(grid, 12);
    const double a = 0.07;
    for (const DerivativeKernel kernel : kernels) {
        const DerivativeMap map = bake_derivatives(depth, kernel);
        const NormalMap normals = bake_normals(depth, a, 1, kernel);
        for (std::size_t k = 0; k < map.du.size(); ++k) {
            // N = (0,0,1), T = (1,0,0), B = (0,1,0) down the image: N x B = (-1,0,0), N x T = (0,1,0).
            const double x = -a * map.du[k], y = -a * map.dv[k] / grid.aspect(), length = std::sqrt(x * x + y * y + 1);
            REQUIRE(normals.x[k] == Approx(x / length).margin(1e-6));
            REQUIRE(normals.y[k] == Approx(-y / length).margin(1e-6)); // y up the image
        }
    }
}

TEST_CASE("Same derivatives for every number of threads") {
    const DepthMap depth = noise(grid_of(33, 41, Wrap::clamp), 2);
    const DerivativeMap alone = bake_derivatives(depth, DerivativeKernel::scharr, 1);
    for (const int threads : {0, 3}) CHECK((bake_derivatives(depth, DerivativeKernel::scharr, threads).du == alone.du));
}

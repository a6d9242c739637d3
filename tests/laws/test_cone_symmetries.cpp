// Laws: a mirrored, turned, shifted or rescaled field has the mirrored, turned, shifted, rescaled map.

#include "bake/cone.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

DepthMap smooth_noise(const TexelGrid& grid) {
    DepthMap map = noise(grid, 11);
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i)
            map.level(i, j) = std::floor(0.3f * map.level(i, j) + 80.0f * float(1 + std::sin(i * 0.3) * std::cos(j * 0.2)));
    return map;
}

template <class Map>
DepthMap moved(const DepthMap& source, TexelGrid grid, Map source_of) {
    DepthMap out{grid, source.bits, Image<float>(grid.width, grid.height)};
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
            const auto [x, y] = source_of(i, j);
            out.level(i, j) = source.level(x, y);
        }
    return out;
}

template <class Map>
void require_moves(const DepthMap& source, TexelGrid grid, double scale, Map source_of) {
    for (Metric metric : {Metric::l2, Metric::l1})
        for (SurfaceModel surface : {SurfaceModel::bilinear, SurfaceModel::texel}) {
            ConeOptions options;
            options.metric = metric, options.surface = surface, options.tolerance = 0, options.ratio_max = 1e6f;
            const Image<float> before = bake_cones(source, options).ratio;
            const Image<float> after = bake_cones(moved(source, grid, source_of), options).ratio;
            for (int j = 0; j < grid.height; ++j)
                for (int i = 0; i < grid.width; ++i) {
                    const auto [x, y] = source_of(i, j);
                    const double expected = scale * before(x, y), cap = 0.999e6 * std::min(scale, 1.0);
                    REQUIRE(std::min(double(after(i, j)), cap) == Approx(std::min(expected, cap)).epsilon(1e-6));
                }
        }
}

} // namespace

TEST_CASE("mirroring and turning the field mirrors and turns the cones") {
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const TexelGrid grid = grid_of(61, 43, wrap), turned = grid_of(43, 61, wrap);
        const DepthMap field = smooth_noise(grid);
        require_moves(field, grid, 1, [](int i, int j) { return std::pair(60 - i, j); });
        require_moves(field, grid, 1, [](int i, int j) { return std::pair(i, 42 - j); });
        // Distances are in widths: a turned map has another width.
        require_moves(field, turned, 61.0 / 43, [](int i, int j) { return std::pair(j, 42 - i); });
    }
}

TEST_CASE("a tiling field shifted by any amount has the shifted cones") {
    const TexelGrid grid = grid_of(61, 43, Wrap::repeat);
    require_moves(smooth_noise(grid), grid, 1, [](int i, int j) { return std::pair((i + 17) % 61, (j + 30) % 43); });
}

TEST_CASE("heights scaled by a power of two scale the cones exactly") {
    const TexelGrid grid = grid_of(61, 43, Wrap::clamp);
    DepthMap field = smooth_noise(grid);
    field.bits = BitDepth::float32;
    for (float& level : field.level) level /= 256;
    ConeOptions options;
    options.ratio_max = 1e5f;
    const Image<float> before = bake_cones(field, options).ratio;
    for (float& level : field.level) level /= 64;
    const Image<float> after = bake_cones(field, options).ratio;
    for (std::size_t k = 0; k < before.size(); ++k)
        if (after[k] < 1e5f * 0.99f) REQUIRE(after[k] == Approx(64 * before[k]).epsilon(2e-3));
}

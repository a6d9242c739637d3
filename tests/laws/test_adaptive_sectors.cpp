// 002's ring search against brute force, and its Algorithm 1 against the erratum (MATHS section 4).

#include "bake/acm_adaptive.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

int sector_of(double x, double y, int sectors) {
    const double turn = 6.283185307179586, angle = std::atan2(y, x);
    return std::min(int((angle < 0 ? angle + turn : angle) / turn * sectors), sectors - 1);
}

/// Every texel centre that a ring search may see, straight from the definition.
float slow_cone(const DepthMap& depth, int x, int y, int sector, int sectors) {
    const TexelGrid& grid = depth.grid;
    const int reach = std::max(grid.width, grid.height) - 1;
    double ratio = 1;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            if ((dx == 0 && dy == 0) || sector_of(dx * grid.pitch_x(), dy * grid.pitch_y(), sectors) != sector) continue;
            const double rise = depth.depth(x, y) - depth.depth(grid.address_x(x + dx), grid.address_y(y + dy));
            if (rise > 0) ratio = std::min(ratio, std::hypot(dx * grid.pitch_x(), dy * grid.pitch_y()) / rise);
        }
    return float(ratio);
}

void check_rings(const DepthMap& depth, int sectors) {
    const std::vector<ConeMap> maps = bake_sector_cones_adaptive(depth, {sectors, 0, 0.05}, {});
    REQUIRE(int(maps.size()) == sectors);
    for (int k = 0; k < sectors; ++k)
        for (int y = 0; y < depth.grid.height; ++y)
            for (int x = 0; x < depth.grid.width; ++x)
                REQUIRE(maps[std::size_t(k)].ratio(x, y) == Approx(slow_cone(depth, x, y, k, sectors)).epsilon(1e-5));
}

} // namespace

TEST_CASE("The ring search finds each sector's cone of texel centres") {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const int sectors : {4, 8})
            for (const auto& [width, height] : {std::pair{1, 1}, {5, 3}, {8, 8}, {13, 7}}) {
                CAPTURE(width, height, sectors);
                check_rings(noise(grid_of(width, height, wrap), std::uint32_t(width * 7 + sectors)), sectors);
                check_rings(adversarial(grid_of(width, height, wrap), "hill"), sectors);
                check_rings(noise(grid_of(width, height, wrap, 1.5), 3), sectors);
            }
}

TEST_CASE("Algorithm 1 copies cones that are too wide: the erratum's low child beside a high one") {
    const DepthMap ridge = depth_of(grid_of(16, 16, Wrap::repeat), [](int x, int) { return x == 4 ? 1 : 0.9; });
    CHECK(bake_sector_cones_adaptive(ridge, {4, 0, 0}, {})[2].ratio(5, 5) == Approx(0.625).epsilon(1e-5));
    CHECK(bake_sector_cones_adaptive(ridge, {4, 1, 0.11}, {})[2].ratio(5, 5) == 1); // its parent is the ridge
}

TEST_CASE("Where Algorithm 1 copies nothing, no cone is wider than the ring search's") {
    std::mt19937 random(5);
    Image<float> heights(12, 6);
    for (std::size_t k = 0; k < heights.size(); ++k) heights[k] = float(uniform(random, 0, 0.5));
    // Each parent is as high as its one child in the corner, so only that child is similar.
    const DepthMap rough = depth_of(grid_of(12, 6, Wrap::repeat), [&](int x, int y) { return heights(x, y) + (x % 2 == 0 && y % 2 == 0 ? 0.5 : 0); });
    for (const int sectors : {4, 8}) {
        const std::vector<ConeMap> rings = bake_sector_cones_adaptive(rough, {sectors, 0, 0}, {}), narrowed = bake_sector_cones_adaptive(rough, {sectors, 2, 0}, {});
        bool narrower = false;
        for (std::size_t k = 0; k < rings.size(); ++k)
            for (int y = 0; y < 6; ++y)
                for (int x = 0; x < 12; ++x) {
                    if (x % 2 == 0 && y % 2 == 0) continue;
                    CHECK(narrowed[k].ratio(x, y) <= rings[k].ratio(x, y));
                    narrower = narrower || narrowed[k].ratio(x, y) < rings[k].ratio(x, y);
                }
        CHECK(narrower); // the parent's cones do bound the search
    }
}

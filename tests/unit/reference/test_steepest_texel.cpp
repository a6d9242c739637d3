#include "shaders-reference/oracle/steepest_texel.h"
#include "tests/support/fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

TEST_CASE("the limiting texel is the one that brute force finds", "[oracle]") {
    std::mt19937 random(9);
    const int sizes[][2] = {{1, 1}, {2, 1}, {1, 3}, {3, 3}, {7, 16}, {17, 13}};
    for (const auto& size : sizes)
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
            for (const Metric metric : {Metric::l2, Metric::l1}) {
                const TexelGrid grid{size[0], size[1], wrap, wrap, 1.5};
                const BilinearSurface surface(noise(grid, random()));
                for (int k = 0; k < 20; ++k) {
                    const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
                    const int tiles = wrap == Wrap::repeat ? 1 : 0;
                    double slope = 0;
                    for (int j = -tiles * grid.height; j < (1 + tiles) * grid.height; ++j)
                        for (int i = -tiles * grid.width; i < (1 + tiles) * grid.width; ++i) {
                            const double x = TexelGrid::centre(i, grid.width) - u;
                            const double y = grid.aspect() * (TexelGrid::centre(j, grid.height) - v);
                            const double distance = metric == Metric::l1 ? std::abs(x) + std::abs(y) : std::hypot(x, y);
                            slope = std::max(slope, (surface.texel(i, j) - surface.height(u, v)) / distance);
                        }
                    // The search's tiles lie around the point's cell, so it may see a little farther.
                    const SteepestTexel found = steepest_texel(surface, u, v, metric, 1e-9);
                    CHECK(found.slope >= slope * (1 - 1e-12));
                    CHECK(found.slope <= slope * 1.2 + (slope == 0 ? 1e-9 : 0));
                }
            }
}

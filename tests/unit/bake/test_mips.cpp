#include "bake/mips.h"
#include "tests/support/cone_fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

double mean_depth(const DepthMap& map) {
    return std::accumulate(map.level.begin(), map.level.end(), 0.0) / double(map.level.size()) / max_code(map.bits);
}

/// Mean depth over a rectangle in texels, each texel a square of one depth.
double box(const DepthMap& map, double x0, double x1, double y0, double y1) {
    double sum = 0;
    for (int j = 0; j < map.grid.height; ++j)
        for (int i = 0; i < map.grid.width; ++i) {
            const double across = std::min(x1, i + 1.0) - std::max(x0, double(i));
            const double down = std::min(y1, j + 1.0) - std::max(y0, double(j));
            if (across > 0 && down > 0) sum += across * down * map.depth(i, j);
        }
    return sum / ((x1 - x0) * (y1 - y0));
}

} // namespace

TEST_CASE("every level halves, to 1 x 1, and is the area average of the one before") {
    for (int width = 1; width <= 17; ++width)
        for (int height : {1, 2, 3, 7, 8, 13}) {
            CAPTURE(width, height);
            const DepthMap top = noise(grid_of(width, height, width % 2 ? Wrap::repeat : Wrap::clamp), std::uint32_t(width));
            DepthMap exact = top;
            exact.bits = BitDepth::float32;
            for (float& level : exact.level) level /= float(max_code(top.bits));
            const std::vector<DepthMap> chain = bake_depth_mips(exact);
            REQUIRE(chain[0].level == exact.level);
            for (std::size_t n = 1; n < chain.size(); ++n) {
                const TexelGrid &above = chain[n - 1].grid, &grid = chain[n].grid;
                REQUIRE(grid.width == std::max(1, above.width / 2));
                REQUIRE(grid.height == std::max(1, above.height / 2));
                REQUIRE(grid.wrap_x == top.grid.wrap_x);
                REQUIRE(grid.aspect() == Approx(top.grid.aspect()));
                const double wide = double(above.width) / grid.width, high = double(above.height) / grid.height;
                for (int j = 0; j < grid.height; ++j)
                    for (int i = 0; i < grid.width; ++i)
                        REQUIRE(chain[n].depth(i, j) == Approx(box(chain[n - 1], i * wide, (i + 1) * wide, j * high,
                                                                   (j + 1) * high)).margin(1e-6));
                REQUIRE(mean_depth(chain[n]) == Approx(mean_depth(exact)).margin(1e-5));
            }
            REQUIRE(chain.back().level.size() == 1);
        }
}

TEST_CASE("codes of a level are those nearest to the mean of the source, not of rounded levels") {
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16}) {
        DepthMap top = noise(grid_of(64, 64, Wrap::repeat), 3);
        top.bits = bits;
        for (float& level : top.level) level *= float(max_code(bits) / 255);
        for (const DepthMap& level : bake_depth_mips(top)) {
            const int side = 64 / level.grid.width;
            for (int j = 0; j < level.grid.height; ++j)
                for (int i = 0; i < level.grid.width; ++i) {
                    double sum = 0;
                    for (int y = 0; y < side; ++y)
                        for (int x = 0; x < side; ++x) sum += top.level(i * side + x, j * side + y);
                    REQUIRE(std::fabs(level.level(i, j) - sum / (side * side)) <= 0.5 + 1e-6);
                }
        }
    }
}

TEST_CASE("levels whose texels are too far from square keep the guarantee") {
    ConeOptions options;
    options.tolerance = 0;
    options.ratio_max = 4;
    options.threads = 1;
    for (const Metric metric : {Metric::l2, Metric::l1})
        for (const double aspect : {0.1, 0.3, 0.45, 2.5, 6.0})
            for (const auto& [width, height] : {std::pair{6, 5}, {1, 7}, {7, 1}, {5, 9}})
                for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
                    CAPTURE(aspect, width, height, int(metric), int(wrap));
                    options.metric = metric;
                    const DepthMap depth = noise(grid_of(width, height, wrap, aspect), 11);
                    const ConeMap cones = bake_level_cones(depth, options);
                    REQUIRE(cones.grid == depth.grid);
                    const Image<float> truth = metric == Metric::l1 ? minimum_3x3(texel_cones(depth, metric, 4), depth.grid)
                                                                    : footprint_cones(depth, 4, 3, 24);
                    for (std::size_t i = 0; i < truth.size(); ++i)
                        REQUIRE(double(cones.ratio[i]) <= double(truth[i]) * (1 + 1e-6));
                }
}

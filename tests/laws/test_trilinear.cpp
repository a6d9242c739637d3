// MATHS section 8: cones of two blended mip levels hold no point of the blended surface.

#include "bake/mips.h"
#include "bake/trilinear.h"
#include "shaders-reference/oracle/bilinear_surface.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

/// What a bilinear sampler returns.
double filtered(const ConeMap& map, double u, double v) {
    const TexelGrid& grid = map.grid;
    const double x = u * grid.width - 0.5, y = v * grid.height - 0.5;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    const double a = x - i, b = y - j;
    const auto at = [&](int k, int l) { return double(map.ratio(grid.address_x(k), grid.address_y(l))); };
    return (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) + b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
}

/// A chain and its surfaces.
struct Chain {
    std::vector<ConeMap> cones;
    std::vector<BilinearSurface> surfaces;
};

Chain chain_of(const DepthMap& top, Metric metric) {
    ConeOptions options;
    options.metric = metric;
    options.ratio_max = 4;
    options.tolerance = 0;
    options.threads = 1;
    Chain chain;
    for (const DepthMap& level : bake_depth_mips(top)) {
        chain.cones.push_back(bake_level_cones(level, options));
        chain.surfaces.emplace_back(level);
    }
    return chain;
}

/// Pairs of points whose slope exceeds what the blended cone at the first one allows.
int violations(const Chain& chain, Metric metric, std::uint32_t seed) {
    std::mt19937 random(seed);
    int count = 0;
    for (std::size_t n = 0; n + 1 < chain.cones.size(); ++n)
        for (int k = 0; k < 6000; ++k) {
            const double f = k % 5 == 0 ? k % 2 : uniform(random, 0, 1);
            const double u = uniform(random, -0.2, 1.2), v = uniform(random, -0.2, 1.2), reach = std::pow(uniform(random, 0.02, 1), 2);
            const double du = uniform(random, -reach, reach), dv = uniform(random, -reach, reach);
            const auto height = [&](double x, double y) {
                return (1 - f) * chain.surfaces[n].height(x, y) + f * chain.surfaces[n + 1].height(x, y);
            };
            const double ratio = (1 - f) * filtered(chain.cones[n], u, v) + f * filtered(chain.cones[n + 1], u, v);
            const double across = std::fabs(du), down = std::fabs(chain.cones[0].grid.aspect() * dv);
            const double distance = metric == Metric::l1 ? across + down : std::hypot(across, down);
            count += (height(u + du, v + dv) - height(u, v)) * ratio > distance * (1 + 1e-6) + 1e-12;
        }
    return count;
}

} // namespace

TEST_CASE("blended cones hold no point of the blended surface, on every odd size; unnarrowed ones do") {
    int unsafe_before = 0;
    for (const auto& [width, height] : {std::pair{16, 16}, {17, 13}, {7, 21}, {31, 5}, {12, 1}, {3, 3}})
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
            for (const Metric metric : {Metric::l2, Metric::l1})
                for (const char* name : {"noise", "stairs", "fine checkerboard"}) {
                    CAPTURE(width, height, int(wrap), int(metric), name);
                    const TexelGrid grid = grid_of(width, height, wrap);
                    Chain chain = chain_of(std::string(name) == "noise" ? noise(grid, 5) : adversarial(grid, name), metric);
                    unsafe_before += violations(chain, metric, 9);
                    narrow_for_trilinear(chain.cones);
                    REQUIRE(violations(chain, metric, 9) == 0);
                }
    CHECK(unsafe_before > 0); // the test can see what it forbids
}

TEST_CASE("a flat chain keeps its cones, and no cone widens") {
    DepthMap flat = adversarial(grid_of(19, 8, Wrap::repeat), "constant");
    Chain chain = chain_of(flat, Metric::l2);
    std::vector<ConeMap> narrowed = chain.cones;
    narrow_for_trilinear(narrowed);
    for (const ConeMap& level : narrowed)
        for (const float ratio : level.ratio) CHECK(ratio == Approx(4));

    chain = chain_of(noise(grid_of(19, 8, Wrap::clamp), 2), Metric::l2);
    narrowed = chain.cones;
    narrow_for_trilinear(narrowed);
    for (std::size_t n = 0; n < narrowed.size(); ++n)
        for (std::size_t i = 0; i < narrowed[n].ratio.size(); ++i)
            REQUIRE(narrowed[n].ratio[i] <= chain.cones[n].ratio[i]);
}

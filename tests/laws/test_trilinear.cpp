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

enum class Planes { one, sectors, stack };

constexpr int count_of(Planes planes) { return planes == Planes::one ? 1 : 4; }

std::vector<ConeMap> baked(const DepthMap& level, Planes planes, const ConeOptions& options) {
    if (planes == Planes::sectors && is_baked_pixel_aspect(level.grid.pixel_aspect)) return bake_sector_cones(level, 4, options);
    if (planes == Planes::stack && is_baked_pixel_aspect(level.grid.pixel_aspect)) return bake_stacked_cones(level, 4, options);
    return std::vector<ConeMap>(std::size_t(count_of(planes)), bake_level_cones(level, options));
}

/// Chains, one for each plane of cones, and the surfaces of their levels.
struct Chains {
    Planes planes;
    std::vector<std::vector<ConeMap>> cones; ///< of each plane, its levels
    std::vector<BilinearSurface> surfaces;
};

Chains chains_of(const DepthMap& top, Metric metric, Planes planes = Planes::one) {
    ConeOptions options;
    options.metric = metric;
    options.ratio_max = 4;
    options.tolerance = 0;
    options.threads = 1;
    Chains chains{planes, std::vector<std::vector<ConeMap>>(std::size_t(count_of(planes))), {}};
    for (const DepthMap& level : bake_depth_mips(top)) {
        std::vector<ConeMap> cones = baked(level, planes, options);
        for (std::size_t plane = 0; plane < cones.size(); ++plane) chains.cones[plane].push_back(std::move(cones[plane]));
        chains.surfaces.emplace_back(level);
    }
    return chains;
}

void narrow(Chains& chains) {
    for (std::vector<ConeMap>& chain : chains.cones) narrow_for_trilinear(chain);
}

/// Pairs of points of which the cone at the first one, blended, holds the second. Each plane is asked where it may be used: a sector
/// in its directions, a level of a stack of points above its apex.
int violations(const Chains& chains, Metric metric, std::uint32_t seed) {
    std::mt19937 random(seed);
    int count = 0;
    for (std::size_t n = 0; n + 1 < chains.surfaces.size(); ++n)
        for (int k = 0; k < 6000; ++k) {
            const double f = k % 5 == 0 ? k % 2 : uniform(random, 0, 1);
            const double u = uniform(random, -0.2, 1.2), v = uniform(random, -0.2, 1.2), reach = std::pow(uniform(random, 0.02, 1), 2);
            const double du = uniform(random, -reach, reach), dv = uniform(random, -reach, reach);
            const auto height = [&](double x, double y) {
                return (1 - f) * chains.surfaces[n].height(x, y) + f * chains.surfaces[n + 1].height(x, y);
            };
            const double across = std::fabs(du), down = std::fabs(chains.cones[0][0].grid.aspect() * dv);
            const double distance = metric == Metric::l1 ? across + down : std::hypot(across, down);
            const std::size_t sector = dv >= 0 ? (du >= 0 ? 0 : 1) : (du < 0 ? 2 : 3);
            for (std::size_t plane = 0; plane < chains.cones.size(); ++plane) {
                if (chains.planes == Planes::sectors && plane != sector) continue;
                const double own = height(u, v), apex = chains.planes == Planes::stack ? own + (1 - own) * double(plane) / 4 : own;
                const double ratio = (1 - f) * filtered(chains.cones[plane][n], u, v) + f * filtered(chains.cones[plane][n + 1], u, v);
                count += (height(u + du, v + dv) - apex) * ratio > distance * (1 + 1e-6) + 1e-12;
            }
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
                    Chains chains = chains_of(std::string(name) == "noise" ? noise(grid, 5) : adversarial(grid, name), metric);
                    unsafe_before += violations(chains, metric, 9);
                    narrow(chains);
                    REQUIRE(violations(chains, metric, 9) == 0);
                }
    CHECK(unsafe_before > 0); // the test can see what it forbids
}

TEST_CASE("so do the cones of each sector, and of each level of a stack") {
    for (const Planes planes : {Planes::sectors, Planes::stack}) {
        int unsafe_before = 0;
        for (const auto& [width, height] : {std::pair{17, 13}, {7, 21}, {31, 5}, {12, 1}})
            for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
                for (const char* name : {"noise", "stairs", "fine checkerboard"}) {
                    CAPTURE(int(planes), width, height, int(wrap), name);
                    const TexelGrid grid = grid_of(width, height, wrap);
                    Chains chains = chains_of(std::string(name) == "noise" ? noise(grid, 5) : adversarial(grid, name), Metric::l2, planes);
                    unsafe_before += violations(chains, Metric::l2, 9);
                    narrow(chains);
                    REQUIRE(violations(chains, Metric::l2, 9) == 0);
                }
        CHECK(unsafe_before > 0);
    }
}

TEST_CASE("a flat chain keeps its cones, and no cone widens") {
    Chains chains = chains_of(adversarial(grid_of(19, 8, Wrap::repeat), "constant"), Metric::l2);
    narrow(chains);
    for (const ConeMap& level : chains.cones[0])
        for (const float ratio : level.ratio) CHECK(ratio == Approx(4));

    chains = chains_of(noise(grid_of(19, 8, Wrap::clamp), 2), Metric::l2);
    const std::vector<ConeMap> before = chains.cones[0];
    narrow(chains);
    for (std::size_t n = 0; n < before.size(); ++n)
        for (std::size_t i = 0; i < before[n].ratio.size(); ++i)
            REQUIRE(chains.cones[0][n].ratio[i] <= before[n].ratio[i]);
}

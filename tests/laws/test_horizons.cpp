// Laws of horizon maps: the exact supremum over the bilinear surface, mirrored, turned, shifted and rescaled with the field.

#include "bake/horizon_map.h"
#include "shaders-reference/oracle/texel_horizon.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr double scale = 0.3;
constexpr double lowest = 0.02; ///< slope below which the oracle need not walk: 50 texture widths

double sine_of(double slope) { return scale * slope / std::sqrt(1 + scale * scale * slope * slope); }

/// Every texel and azimuth against the oracle's line, which walks cells in double precision and knows no hull.
void require_exact(const DepthMap& depth) {
    const HorizonMap map = bake_horizons(depth, scale, 1);
    const BilinearSurface surface(depth);
    const TexelGrid& grid = depth.grid;
    for (int k = 0; k < horizon_azimuths; ++k)
        for (int j = 0; j < grid.height; ++j)
            for (int i = 0; i < grid.width; ++i) {
                const double slope = texel_horizon(surface, i, j, Heading::from_angle(horizon_angle(grid, k)), 1 / lowest);
                CAPTURE(grid.width, grid.height, int(grid.wrap_x), int(grid.wrap_y), grid.pixel_aspect, k, i, j);
                const double sine = map.sine[std::size_t(k)](i, j);
                if (slope > 0) REQUIRE(sine == Approx(sine_of(slope)).margin(1e-6));
                else REQUIRE(sine <= sine_of(lowest) + 1e-6);
            }
}

/// Azimuth that azimuth k becomes under a map of directions.
template <class Turn>
std::size_t turned(int k, Turn turn) {
    const auto step = turn(horizon_steps[std::size_t(k)]);
    return std::size_t(std::find(horizon_steps.begin(), horizon_steps.end(), step) - horizon_steps.begin());
}

DepthMap spike(const TexelGrid& grid, int x, int y) {
    return depth_of(grid, [=](int i, int j) { return i == x && j == y ? 1.0 : 0.0; });
}

} // namespace

TEST_CASE("horizons are the oracle's, on every small size, addressing and pixel shape") {
    std::uint32_t seed = 1;
    for (const auto& [w, h] : {std::pair(1, 1), std::pair(1, 5), std::pair(4, 1), std::pair(2, 2), std::pair(3, 5), std::pair(6, 4), std::pair(8, 8), std::pair(13, 9)})
        for (const Wrap wrap_x : {Wrap::repeat, Wrap::clamp})
            for (const Wrap wrap_y : {Wrap::repeat, Wrap::clamp})
                for (const double aspect : {1.0, 0.7, 1.6}) require_exact(noise({w, h, wrap_x, wrap_y, aspect}, seed++));
}

TEST_CASE("horizons are the oracle's on adversarial fields") {
    for (const std::string& name : adversarial_names())
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
            for (const BitDepth bits : {BitDepth::unorm16, BitDepth::float32})
                require_exact(adversarial(grid_of(32, 20, wrap, name == "bowl" ? 1.4 : 1), name, bits));
    // Bulging cells one behind the other: the hull's arcs touch each other's ends.
    for (const double curve : {0.02, -0.02}) {
        require_exact(depth_of(grid_of(24, 24, Wrap::clamp), [&](int i, int j) { return 0.5 + curve * (i - 12) * (j - 12) / 12.0; }));
        require_exact(depth_of(grid_of(24, 24, Wrap::clamp), [&](int i, int j) { return 0.5 + curve * (i - j) * (i - j) / 24.0; }));
    }
}

TEST_CASE("a spike's horizon is height over distance, along every azimuth") {
    const int side = 31, middle = 15;
    const TexelGrid grid = grid_of(side, side, Wrap::clamp, 0.8);
    const HorizonMap map = bake_horizons(spike(grid, middle, middle), scale);
    for (int k = 0; k < horizon_azimuths; ++k)
        for (int n = 1; n <= middle; ++n) {
            const auto [dx, dy] = horizon_steps[std::size_t(k)];
            const double distance = n * std::hypot(dx * grid.pitch_x(), dy * grid.pitch_y());
            REQUIRE(map.sine[std::size_t(k)](middle - n * dx, middle - n * dy) == Approx(sine_of(1 / distance)).epsilon(1e-7));
            REQUIRE(map.sine[std::size_t(k)](middle + n * dx, middle + n * dy) == 0);
        }
}

TEST_CASE("a saddle's horizon lies inside its cell") {
    // h10 = h01 = 1, h00 = h11 = 0: the diagonal sees 2 t (1 - t), from n texels before touched at t = sqrt(n^2 + n) - n.
    const TexelGrid grid = grid_of(16, 16, Wrap::clamp);
    const DepthMap depth = depth_of(grid, [](int i, int j) { return (i == 9 && j == 8) || (i == 8 && j == 9) ? 1.0 : 0.0; });
    const Image<float> sine = bake_horizons(depth, scale).sine[1];
    for (int n = 1; n <= 8; ++n) {
        const double t = std::sqrt(double(n) * n + n) - n, slope = 2 * t * (1 - t) / (n + t) / (std::sqrt(2.0) / 16);
        REQUIRE(sine(8 - n, 8 - n) == Approx(sine_of(slope)).epsilon(1e-7));
    }
}

TEST_CASE("mirroring and turning the field mirrors and turns the horizons, bit for bit") {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const TexelGrid grid = grid_of(21, 14, wrap), other = grid_of(14, 21, wrap);
        const DepthMap field = noise(grid, 5);
        DepthMap mirrored = field, transposed{other, field.bits, Image<float>(14, 21)};
        for (int j = 0; j < 14; ++j)
            for (int i = 0; i < 21; ++i) mirrored.level(i, j) = field.level(20 - i, j), transposed.level(j, i) = field.level(i, j);
        const HorizonMap before = bake_horizons(field, scale), mirror = bake_horizons(mirrored, scale);
        // A transposed map has another width, in which the depth is measured.
        const HorizonMap transpose = bake_horizons(transposed, scale * 21 / 14);
        for (int k = 0; k < horizon_azimuths; ++k) {
            const Image<float>& plane = before.sine[std::size_t(k)];
            const Image<float>& left = mirror.sine[turned(k, [](auto s) { return std::pair(-s.first, s.second); })];
            const Image<float>& over = transpose.sine[turned(k, [](auto s) { return std::pair(s.second, s.first); })];
            for (int j = 0; j < 14; ++j)
                for (int i = 0; i < 21; ++i) {
                    REQUIRE(left(20 - i, j) == plane(i, j));
                    REQUIRE(over(j, i) == Approx(plane(i, j)).epsilon(1e-6).margin(1e-9));
                }
        }
    }
}

TEST_CASE("a tiling field shifted by any amount has the shifted horizons") {
    const TexelGrid grid = grid_of(20, 15, Wrap::repeat);
    const DepthMap field = noise(grid, 8);
    DepthMap shifted = field;
    for (int j = 0; j < 15; ++j)
        for (int i = 0; i < 20; ++i) shifted.level(i, j) = field.level((i + 7) % 20, (j + 4) % 15);
    const HorizonMap before = bake_horizons(field, scale), after = bake_horizons(shifted, scale);
    for (std::size_t k = 0; k < horizon_azimuths; ++k)
        for (int j = 0; j < 15; ++j)
            for (int i = 0; i < 20; ++i) REQUIRE(after.sine[k](i, j) == Approx(before.sine[k]((i + 7) % 20, (j + 4) % 15)).epsilon(1e-6));
}

TEST_CASE("half the height and twice the depth scale give the same horizons") {
    DepthMap field = noise(grid_of(19, 12, Wrap::clamp), 4);
    field.bits = BitDepth::float32;
    for (float& level : field.level) level /= 256;
    const HorizonMap before = bake_horizons(field, scale);
    for (float& level : field.level) level /= 2;
    CHECK(bake_horizons(field, 2 * scale).sine == before.sine);
}

TEST_CASE("flat maps have no horizon; every number of threads has the same") {
    for (const Image<float>& plane : bake_horizons(adversarial(grid_of(9, 7, Wrap::repeat), "constant"), scale).sine)
        for (const float sine : plane) REQUIRE((sine == 0 && !std::signbit(sine)));
    const DepthMap field = noise(grid_of(67, 45, Wrap::repeat), 6);
    const HorizonMap alone = bake_horizons(field, scale, 1);
    for (const int threads : {2, 5}) CHECK(bake_horizons(field, scale, threads).sine == alone.sine);
}

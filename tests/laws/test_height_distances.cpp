// Cones against the height distributional distance transform, which finds them by distances alone: on whole real maps too, where
// comparing all pairs of texels is out of reach.

#include "bake/cone.h"
#include "formats/read_image.h"
#include "tests/support/cone_fields.h"
#include "tests/support/height_distances.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr float ratio_max = 4;
constexpr double roundings = 3e-6; ///< of a slope in floats, and the bake's margin for them

ConeOptions exact(SurfaceModel surface, Metric metric) {
    ConeOptions options;
    options.surface = surface, options.metric = metric;
    options.tolerance = 0, options.ratio_max = ratio_max, options.threads = 1;
    return options;
}

Image<float> cones_of(const HeightDistances& distances, const TexelGrid& grid, double lift) {
    Image<float> cones(grid.width, grid.height);
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) cones(i, j) = float(distances.cone(i, j, lift, ratio_max));
    return cones;
}

void require_equal(const Image<float>& baked, const Image<float>& truth) {
    for (std::size_t k = 0; k < truth.size(); ++k) {
        CAPTURE(k, truth.width(), truth.height());
        REQUIRE(double(baked[k]) <= double(truth[k]) * (1 + 1e-6));
        REQUIRE(double(baked[k]) >= double(truth[k]) * (1 - roundings));
    }
}

/// No cone of the surface is wider than one of its texel centres; returns the mean share.
double require_within(const Image<float>& baked, const Image<float>& bound) {
    double share = 0;
    for (std::size_t k = 0; k < bound.size(); ++k) {
        CAPTURE(k, bound.width(), bound.height());
        REQUIRE(double(baked[k]) <= double(bound[k]) * (1 + 1e-6));
        share += double(baked[k]) / double(bound[k]) / double(bound.size());
    }
    return share;
}

/// The least of a cell's four texels, stored at its first.
Image<float> minimum_2x2(const Image<float>& values, const TexelGrid& g) {
    Image<float> out = values;
    for (int j = 0; j < g.height; ++j)
        for (int i = 0; i < g.width; ++i)
            for (int k = 1; k < 4; ++k) out(i, j) = std::min(out(i, j), values(g.address_x(i + k % 2), g.address_y(j + k / 2)));
    return out;
}

/// Texel cones equal what distances say. Every texel centre lies in the closed cells around its neighbours, so that what the
/// bilinear surface asks of a cone is at least what texel centres ask of the 3 x 3 around it; in L1 it is just that.
void check(const DepthMap& depth) {
    for (Metric metric : {Metric::l2, Metric::l1}) {
        CAPTURE(int(metric), depth.grid.width, depth.grid.height, depth.grid.wrap_x == Wrap::repeat, depth.grid.pixel_aspect);
        const HeightDistances distances(depth, metric);
        const Image<float> texels = cones_of(distances, depth.grid, 0), around = minimum_3x3(texels, depth.grid);
        require_equal(bake_cones(depth, exact(SurfaceModel::texel, metric)).ratio, texels);
        const Image<float> bilinear = bake_cones(depth, exact(SurfaceModel::bilinear, metric)).ratio;
        if (metric == Metric::l1) require_equal(bilinear, around);
        else REQUIRE(require_within(bilinear, around) > 0.6);
    }
}

DepthMap read_depth(const char* name, const char* channel, InputKind input) {
    const auto source = read_image(std::filesystem::path(RELIEFBAKE_TEST_DATA) / "heights" / name, {channel, 0});
    REQUIRE(source);
    HeightOptions options;
    options.input = input;
    const auto height = make_height_field(source->plane, source->is_integer, options, name);
    REQUIRE(height);
    return quantise_depth(height->field, BitDepth::unorm8);
}

} // namespace

TEST_CASE("the distance transform equals brute force") {
    std::mt19937 random(3);
    for (int round = 0; round < 60; ++round) {
        TexelGrid grid = grid_of(1 + int(random() % 17), 1 + int(random() % 13), Wrap::repeat, uniform(random, 0.5, 2));
        if (random() % 2 == 0) grid.wrap_x = Wrap::clamp;
        if (random() % 2 == 0) grid.wrap_y = Wrap::clamp;
        Image<char> set(grid.width, grid.height);
        const unsigned rarity = 1 + random() % 60;
        for (char& texel : set) texel = random() % rarity == 0;
        for (Metric metric : {Metric::l2, Metric::l1}) {
            const Image<double> found = distance_transform(set, grid, metric);
            for (int j = 0; j < grid.height; ++j)
                for (int i = 0; i < grid.width; ++i) {
                    double nearest = std::numeric_limits<double>::infinity();
                    for (int b = -grid.height; b < 2 * grid.height; ++b)
                        for (int a = -grid.width; a < 2 * grid.width; ++a) {
                            const bool inside = a >= 0 && a < grid.width && b >= 0 && b < grid.height;
                            const bool there = (grid.wrap_x == Wrap::repeat || (a >= 0 && a < grid.width)) &&
                                               (grid.wrap_y == Wrap::repeat || (b >= 0 && b < grid.height));
                            if (!(inside || there) || !set(grid.address_x(a), grid.address_y(b))) continue;
                            const double dx = (a - i) * grid.pitch_x(), dy = (b - j) * grid.pitch_y();
                            nearest = std::min(nearest, metric == Metric::l1 ? std::fabs(dx) + std::fabs(dy) : std::hypot(dx, dy));
                        }
                    if (std::isinf(nearest)) REQUIRE(std::isinf(found(i, j)));
                    else REQUIRE(found(i, j) == Approx(nearest).margin(1e-12));
                }
        }
    }
}

TEST_CASE("cones of small maps are what distances to higher texels say") {
    std::mt19937 random(8);
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        for (const std::string& name : adversarial_names()) check(adversarial(grid_of(37, 29, wrap), name, BitDepth::unorm8));
        for (int round = 0; round < 8; ++round) {
            const TexelGrid grid = grid_of(1 + int(random() % 70), 1 + int(random() % 50), wrap, uniform(random, 0.5, 2));
            check(noise(grid, random()));
            check(bumpy(grid, random() % 100));
        }
    }
}

TEST_CASE("cones of whole real maps are what distances to higher texels say") {
    check(read_depth("pom_rocks_NM_height.tga", "A", InputKind::height));
    check(read_depth("bevy_parallax_cube_depth_348.png", "", InputKind::depth));
}

TEST_CASE("lifted cones and cones of cells are no wider than distances to higher texels allow") {
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (std::uint32_t seed : {1u, 2u, 3u}) {
            const DepthMap depth = bumpy(grid_of(61, 43, wrap), seed);
            const HeightDistances distances(depth, Metric::l2);
            ConeOptions options = exact(SurfaceModel::bilinear, Metric::l2);
            const std::vector<ConeMap> stack = bake_stacked_cones(depth, 3, options);
            for (int k = 0; k < 3; ++k)
                REQUIRE(require_within(stack[std::size_t(k)].ratio, minimum_3x3(cones_of(distances, depth.grid, k / 3.0), depth.grid)) > 0.5);
            options.lookup = ConeLookup::cell;
            REQUIRE(require_within(bake_cones(depth, options).ratio, minimum_2x2(cones_of(distances, depth.grid, 0), depth.grid)) > 0.6);
        }
}

TEST_CASE("a cone one part in 100 000 off is seen") {
    const DepthMap depth = noise(grid_of(33, 21, Wrap::repeat), 4);
    const HeightDistances distances(depth, Metric::l2);
    const Image<float> truth = cones_of(distances, depth.grid, 0);
    Image<float> baked = bake_cones(depth, exact(SurfaceModel::texel, Metric::l2)).ratio;
    for (const float factor : {1.00001f, 0.99999f}) {
        int seen = 0;
        for (std::size_t k = 0; k < truth.size(); ++k) {
            const double share = double(baked[k] * factor) / double(truth[k]);
            seen += share > 1 + 1e-6 || share < 1 - roundings;
        }
        REQUIRE(seen == int(truth.size()));
    }
}

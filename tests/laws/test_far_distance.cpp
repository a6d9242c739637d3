// The inequality behind the far constraints (docs/SAFETY.md): the bilinear interpolant, between integer displacements,
// of the deflated distance nowhere exceeds the distance. Near: every cell, by a bound. Far: a margin that grows.

#include "bake/search_surface.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace reliefbake;

namespace {

SearchSurface surface_with(double pixel_aspect) {
    SearchSurface surface{};
    surface.grid = {8, 8, Wrap::clamp, Wrap::clamp, pixel_aspect};
    return surface;
}

/// Largest excess of the interpolant over the distance in the cell of displacements at (i, j), at n x n points.
double worst_excess(const SearchSurface& s, int i, int j, int n) {
    const double a = s.grid.pixel_aspect;
    const double p00 = deflated_distance(s, i, j), p10 = deflated_distance(s, i + 1, j);
    const double p01 = deflated_distance(s, i, j + 1), p11 = deflated_distance(s, i + 1, j + 1);
    double worst = -1e9;
    for (int v = 0; v <= n; ++v)
        for (int u = 0; u <= n; ++u) {
            const double x = double(u) / n, y = double(v) / n;
            const double interpolant = (1 - y) * ((1 - x) * p00 + x * p10) + y * ((1 - x) * p01 + x * p11);
            worst = std::max(worst, interpolant - std::hypot(i + x, a * (j + y)));
        }
    return worst;
}

} // namespace

TEST_CASE("deflated distances interpolate below the distance, for every displacement of a texel or more") {
    for (double aspect : {0.5, 0.7, 1.0, 1.3, 2.0}) {
        const SearchSurface s = surface_with(aspect);
        for (int j = 0; j < 160; ++j)
            for (int i = 0; i < 160; ++i) {
                if (std::max(i, j) < 2) continue; // nearer pairs are not bounded this way
                CAPTURE(aspect, i, j);
                // Between samples the excess changes by less than its curvature (below 1 / distance) allows.
                REQUIRE(worst_excess(s, i, j, 8) < 0);
            }
    }
}

TEST_CASE("mutation: a deflation of less than a quarter is caught") {
    SearchSurface s = surface_with(1);
    const double at_8 = worst_excess(s, 8, 0, 64);
    REQUIRE(at_8 < 0);
    // With the undeflated distance the same cell exceeds.
    s.model = SurfaceModel::texel;
    REQUIRE(worst_excess(s, 8, 0, 64) > 0.01);
}

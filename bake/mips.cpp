#include "bake/mips.h"

#include "bake/stored_code.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

/// The texels under one texel of the next level, and their shares of it. A texel of the next level is n/m texels wide,
/// m = floor(n/2): two when n is even; 2 + 1/m when n is odd, three taps whose shares slide (Guthe & Heckbert 2005,
/// "Non-power-of-two mipmapping"). Both tile the image exactly: no tap lies beyond the border, so addressing plays no part.
struct Taps {
    int first, count;
    double share[3];
};

Taps taps(int i, int n) {
    if (n == 1) return {0, 1, {1, 0, 0}};
    if (n % 2 == 0) return {2 * i, 2, {0.5, 0.5, 0}};
    const double m = n / 2;
    return {2 * i, 3, {(m - i) / n, m / n, (i + 1.0) / n}};
}

Image<double> halved(const Image<double>& from) {
    Image<double> to(std::max(1, from.width() / 2), std::max(1, from.height() / 2));
    for (int y = 0; y < to.height(); ++y)
        for (int x = 0; x < to.width(); ++x) {
            const Taps across = taps(x, from.width()), down = taps(y, from.height());
            double sum = 0;
            for (int j = 0; j < down.count; ++j)
                for (int i = 0; i < across.count; ++i)
                    sum += down.share[j] * across.share[i] * from(across.first + i, down.first + j);
            to(x, y) = sum;
        }
    return to;
}

/// Of the same proportions with other numbers of texels.
TexelGrid resized(TexelGrid grid, int width, int height) {
    grid.pixel_aspect = grid.aspect() * width / height;
    grid.width = width;
    grid.height = height;
    return grid;
}

/// Area averages of one level, unrounded.
struct Average {
    Image<double> depth; ///< of what is solid, times the share that is
    Image<double> solid; ///< that share, 0..1; empty: all is
};

Average average_of(const DepthMap& depth) {
    Average average{Image<double>(depth.grid.width, depth.grid.height), {}};
    for (std::size_t i = 0; i < average.depth.size(); ++i) average.depth[i] = double(depth.level[i]) / max_code(depth.bits);
    if (!depth.holes) return average;
    average.solid = Image<double>(depth.grid.width, depth.grid.height, 1);
    for (int y = 0; y < depth.grid.height; ++y)
        for (int x = 0; x < depth.grid.width; ++x)
            if (depth.is_hole(x, y)) average.solid(x, y) = average.depth(x, y) = 0;
    return average;
}

DepthMap stored(const Average& average, const TexelGrid& grid, BitDepth bits) {
    const bool holes = !average.solid.empty();
    DepthMap map{grid, bits, Image<float>(grid.width, grid.height), holes};
    const StoredCode floor = nearest_code(1, bits);
    for (std::size_t i = 0; i < average.depth.size(); ++i) {
        // The shares add up to 1 but for rounding, so a mean may leave 0..1 by as much; and one of halves may be a little less.
        const double solid = holes ? average.solid[i] : 1;
        const bool is_hole = solid < 0.5 * (1 - 1e-12);
        StoredCode code = is_hole ? floor : nearest_code(std::clamp(average.depth[i] / solid, 0.0, 1.0), bits);
        if (holes && !is_hole) code = std::min(code, floor - 1);
        map.level[i] = is_unorm(bits) ? float(code) : stored_value(code, bits);
    }
    return map;
}

float rounded_down(double x) {
    const float nearest = float(x);
    return nearest > x ? std::nextafter(nearest, 0.0f) : nearest;
}

} // namespace

std::vector<DepthMap> bake_depth_mips(const DepthMap& depth) {
    Average average = average_of(depth);
    std::vector<DepthMap> levels{depth};
    while (average.depth.width() > 1 || average.depth.height() > 1) {
        average.depth = halved(average.depth);
        if (depth.holes) average.solid = halved(average.solid);
        levels.push_back(stored(average, resized(depth.grid, average.depth.width(), average.depth.height()), depth.bits));
    }
    return levels;
}

/// Distances are |(du, a dv)| with the pixel aspect a. Baked with a' instead, they are too short where a' < a: safe. Where
/// a' > a they are too long by a'/a at most, in either metric, and so are the ratios (distance over height difference):
///     r = r' a / a'.
ConeMap bake_level_cones(const DepthMap& depth, const ConeOptions& options, ConeStatistics* statistics, SharedPyramids* shared) {
    const double aspect = depth.grid.pixel_aspect;
    if (is_baked_pixel_aspect(aspect)) return bake_cones(depth, options, statistics, shared);
    DepthMap baked = depth;
    baked.grid.pixel_aspect = std::clamp(aspect, least_pixel_aspect, largest_pixel_aspect);
    const double scale = std::min(1.0, aspect / baked.grid.pixel_aspect);
    ConeOptions wider = options; // so that the cap is met after scaling
    wider.ratio_max = float(options.ratio_max / scale);
    ConeMap cones = bake_cones(baked, wider, statistics, shared);
    cones.grid = depth.grid;
    cones.options = options;
    for (float& ratio : cones.ratio) ratio = std::min(rounded_down(double(ratio) * scale), options.ratio_max);
    return cones;
}

} // namespace reliefbake

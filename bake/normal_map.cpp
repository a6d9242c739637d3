#include "bake/normal_map.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

// x and y are stored as floats: below this length 1 - x^2 - y^2 stays positive in float arithmetic too.
constexpr double longest_xy = 1 - 1.0 / (1 << 22);

} // namespace

NormalMap bake_normals(const DepthMap& depth, double depth_scale, int threads, DerivativeKernel kernel) {
    const int width = depth.grid.width, height = depth.grid.height;
    NormalMap map{depth.grid, Image<float>(width, height), Image<float>(width, height)};
    const DepthSlopes slopes(depth, kernel);
    const double per_x = depth_scale / depth.grid.pitch_x(), per_y = depth_scale / depth.grid.pitch_y();
    parallel_for(height, threads, [&](int y) {
        for (int x = 0; x < width; ++x) {
            // The surface height is -depth: its normal is (d depth/du, d depth/d up, 1), and up is -down.
            const double nx = slopes.along_x(x, y) * per_x, ny = -slopes.down_y(x, y) * per_y;
            const double length = std::sqrt(nx * nx + ny * ny + 1);
            const double xy = std::sqrt(nx * nx + ny * ny) / length;
            const double shrink = std::min(1.0, longest_xy / xy) / length;
            map.x(x, y) = float(nx * shrink);
            map.y(x, y) = float(ny * shrink);
        }
    });
    return map;
}

} // namespace reliefbake

#include "bake/derivative_map.h"

#include "bake/parallel.h"

namespace reliefbake {

DerivativeMap bake_derivatives(const DepthMap& depth, DerivativeKernel kernel, int threads) {
    const int width = depth.grid.width, height = depth.grid.height;
    DerivativeMap map{depth.grid, Image<float>(width, height), Image<float>(width, height)};
    const DepthSlopes slopes(depth, kernel);
    parallel_for(height, threads, [&](int y) {
        for (int x = 0; x < width; ++x) {
            // Subtracted from 0: where the map is flat the result is 0, not -0.
            map.du(x, y) = float(0 - slopes.along_x(x, y) * width);
            map.dv(x, y) = float(0 - slopes.down_y(x, y) * height);
        }
    });
    return map;
}

} // namespace reliefbake

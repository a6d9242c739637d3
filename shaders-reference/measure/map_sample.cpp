#include "shaders-reference/measure/map_sample.h"

#include <cmath>

namespace reliefbake {

double filtered_code(const Image<float>& channel, const TexelGrid& grid, double u, double v) {
    const double x = u * grid.width - 0.5;
    const double y = v * grid.height - 0.5;
    const int i = int(std::floor(x));
    const int j = int(std::floor(y));
    const double a = x - i;
    const double b = y - j;
    const float* top = channel.row(grid.address_y(j));
    const float* bottom = channel.row(grid.address_y(j + 1));
    const int left = grid.address_x(i);
    const int right = grid.address_x(i + 1);
    return (1 - b) * ((1 - a) * top[left] + a * top[right]) + b * ((1 - a) * bottom[left] + a * bottom[right]);
}

double sampled_ratio(const ReliefMap& map, const Image<float>& codes, double u, double v, Fetch fetch) {
    const TexelGrid& grid = map.grid;
    double code = 0, depth = 0;
    if (fetch == Fetch::bilinear) {
        code = filtered_code(codes, grid, u, v);
        depth = filtered_code(map.depth, grid, u, v);
    } else if (fetch == Fetch::cell) {
        code = codes(grid.address_x(int(std::floor(u * grid.width - 0.5))), grid.address_y(int(std::floor(v * grid.height - 0.5))));
        depth = filtered_code(map.depth, grid, u, v);
    } else {
        const int i = grid.address_x(int(std::floor(u * grid.width)));
        const int j = grid.address_y(int(std::floor(v * grid.height)));
        code = codes(i, j);
        depth = map.depth(i, j);
    }
    return decode_ratio(code, depth, map.info.encoding, map.info.cone_max);
}

} // namespace reliefbake

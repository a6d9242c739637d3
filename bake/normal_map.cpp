#include "bake/normal_map.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

/// Depth change per texture width along one axis: central inside and across a repeating border, one-sided at
/// a clamped one, 0 on an axis of one texel.
class Slopes {
  public:
    Slopes(const DepthMap& depth, double depth_scale)
        : depth_(depth), per_x_(depth_scale / depth.grid.pitch_x()),
          per_y_(depth_scale / depth.grid.pitch_y()) {}

    double x(int x, int y) const {
        const TexelGrid& g = depth_.grid;
        const double rise = depth_.depth(g.address_x(x + 1), y) - depth_.depth(g.address_x(x - 1), y);
        return rise / steps(x, g.width, g.wrap_x) * per_x_;
    }
    double down(int x, int y) const {
        const TexelGrid& g = depth_.grid;
        const double rise = depth_.depth(x, g.address_y(y + 1)) - depth_.depth(x, g.address_y(y - 1));
        return rise / steps(y, g.height, g.wrap_y) * per_y_;
    }

  private:
    /// Texels between the two neighbours that texel i's difference takes.
    static int steps(int i, int count, Wrap wrap) {
        if (wrap == Wrap::repeat) return 2;
        return std::max(1, std::min(i + 1, count - 1) - std::max(i - 1, 0));
    }

    const DepthMap& depth_;
    double per_x_, per_y_;
};

// x and y are stored as floats: below this length 1 - x^2 - y^2 stays positive in float arithmetic too.
constexpr double longest_xy = 1 - 1.0 / (1 << 22);

} // namespace

NormalMap bake_normals(const DepthMap& depth, double depth_scale, int threads) {
    const int width = depth.grid.width, height = depth.grid.height;
    NormalMap map{depth.grid, Image<float>(width, height), Image<float>(width, height)};
    const Slopes slopes(depth, depth_scale);
    parallel_for(height, threads, [&](int y) {
        for (int x = 0; x < width; ++x) {
            // The surface height is -depth: its normal is (d depth/du, d depth/d up, 1), and up is -down.
            const double nx = slopes.x(x, y), ny = -slopes.down(x, y);
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

#pragma once
// Differences of the stored depth, from which normals and derivatives are made: kernels and borders live here.

#include "bake/height_field.h"

#include <algorithm>

namespace reliefbake {

/// How a derivative averages over the three rows (columns) that it touches. Each is exact on planes.
enum class DerivativeKernel {
    central, ///< the texel's own row alone: (h(i+1) - h(i-1)) / 2
    sobel,   ///< rows weigh 1 2 1 (over 4): less noise, one texel blurrier across
    scharr,  ///< rows weigh 3 10 3 (over 16): of the three the nearest to turning with the image (Scharr 2000)
};

/// Depth change per texel at a texel: central inside and across a repeating border, one-sided at a clamped one, 0 on an axis
/// of one texel; on solid ground one-sided beside a hole, so that its edge keeps its own slope. Differences are taken between stored levels, so that a flat or straight map has exact ones.
class DepthSlopes {
  public:
    DepthSlopes(const DepthMap& depth, DerivativeKernel kernel)
        : depth_(depth), grid_(depth.grid), own_(kernel == DerivativeKernel::scharr ? 10 : 2),
          side_(kernel == DerivativeKernel::central ? 0 : kernel == DerivativeKernel::sobel ? 1 : 3),
          full_(max_code(depth.bits) * (own_ + 2 * side_)) {}

    double along_x(int x, int y) const {
        const int left = grid_.address_x(x - 1), right = grid_.address_x(x + 1);
        const auto rise = [&](int row) { return rise_between({left, row}, {x, row}, {right, row}); };
        double sum = own_ * rise(y);
        if (side_ > 0) sum += side_ * (rise(grid_.address_y(y - 1)) + rise(grid_.address_y(y + 1)));
        return sum / (full_ * steps(x, grid_.width, grid_.wrap_x));
    }
    double down_y(int x, int y) const {
        const int above = grid_.address_y(y - 1), below = grid_.address_y(y + 1);
        const auto rise = [&](int column) { return rise_between({column, above}, {column, y}, {column, below}); };
        double sum = own_ * rise(x);
        if (side_ > 0) sum += side_ * (rise(grid_.address_x(x - 1)) + rise(grid_.address_x(x + 1)));
        return sum / (full_ * steps(y, grid_.height, grid_.wrap_y));
    }

  private:
    struct Texel {
        int x, y;
    };
    double level(Texel t) const { return depth_.level(t.x, t.y); }
    bool is_hole(Texel t) const { return depth_.is_hole(t.x, t.y); }

    /// From the texel before to the one after. A hole beside solid ground counts as the mirror of the other side.
    double rise_between(Texel before, Texel here, Texel after) const {
        if (!depth_.holes || is_hole(here)) return level(after) - level(before);
        if (is_hole(before) && is_hole(after)) return 0;
        if (is_hole(before)) return 2 * (level(after) - level(here));
        return is_hole(after) ? 2 * (level(here) - level(before)) : level(after) - level(before);
    }

    /// Texels between the two neighbours that texel i's difference takes.
    static int steps(int i, int count, Wrap wrap) {
        if (wrap == Wrap::repeat) return 2;
        return std::max(1, std::min(i + 1, count - 1) - std::max(i - 1, 0));
    }

    const DepthMap& depth_;
    const TexelGrid& grid_;
    double own_, side_; ///< weights of the texel's own row and of the two beside it
    double full_;       ///< largest level times the sum of the weights
};

} // namespace reliefbake

#include "shaders-reference/renderer/max_mip.h"

#include <algorithm>
#include <bit>

namespace reliefbake {

MaxMip build_max_mip(const Image<float>& depth, const TexelGrid& grid) {
    constexpr float rounding = 1 - 0x1p-22f; // a driver may turn a code into a float one ulp lower than we do
    MaxMip mip;
    const int first_x = grid.wrap_x == Wrap::repeat ? 0 : -1;
    const int first_y = grid.wrap_y == Wrap::repeat ? 0 : -1;
    mip.cells_x = grid.width - first_x;
    mip.cells_y = grid.height - first_y;

    // The cells; padding is as deep as can be and never looked at.
    Image<float> level(int(std::bit_ceil(unsigned(mip.cells_x))), int(std::bit_ceil(unsigned(mip.cells_y))), 1.0f);
    for (int y = 0; y < mip.cells_y; ++y)
        for (int x = 0; x < mip.cells_x; ++x) {
            const int left = grid.address_x(x + first_x), right = grid.address_x(x + first_x + 1);
            const int top = grid.address_y(y + first_y), bottom = grid.address_y(y + first_y + 1);
            level(x, y) = rounding * std::min({depth(left, top), depth(right, top), depth(left, bottom), depth(right, bottom)});
        }
    mip.levels.push_back(std::move(level));

    // Halve both sides as OpenGL does, to one texel.
    while (mip.levels.back().width() > 1 || mip.levels.back().height() > 1) {
        const Image<float>& fine = mip.levels.back();
        Image<float> coarse(std::max(1, fine.width() / 2), std::max(1, fine.height() / 2));
        for (int y = 0; y < coarse.height(); ++y)
            for (int x = 0; x < coarse.width(); ++x) {
                const int right = std::min(2 * x + 1, fine.width() - 1), bottom = std::min(2 * y + 1, fine.height() - 1);
                coarse(x, y) = std::min({fine(2 * x, 2 * y), fine(right, 2 * y), fine(2 * x, bottom), fine(right, bottom)});
            }
        mip.levels.push_back(std::move(coarse));
    }
    return mip;
}

} // namespace reliefbake

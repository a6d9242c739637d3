#pragma once
// The pyramid that glsl/max_mip.glsl descends (Tevs, Ihrke and Seidel 2008).

#include "bake/relief_map.h"

#include <vector>

namespace reliefbake {

struct MaxMip {
    int cells_x = 0, cells_y = 0;     ///< of one tile; a clamped axis has a half cell at either end
    std::vector<Image<float>> levels; ///< least depth of each block, rounded down; [0]: a cell. Sides are powers of two
    int top() const { return int(levels.size()) - 1; }
};

MaxMip build_max_mip(const Image<float>& depth, const TexelGrid& grid);

} // namespace reliefbake

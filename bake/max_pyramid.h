#pragma once
// A max pyramid whose nodes also carry a plane that lies on or above them (MATHS section 2, "Computing it fast").
// Straight flanks prune by the plane where the maximum alone would visit every node of the flank.

#include "bake/image.h"

#include <vector>

namespace reliefbake {

/// One square of texels. Coordinates and distances are in texels; heights in the units of the input.
/// For every texel (x,y) of the node: height <= max and height <= plane + gx (x - cx) + gy (y - cy).
struct PyramidNode {
    float max;
    float cx, cy;           ///< centre of the box of its texels' centres
    float half_x, half_y;   ///< half extents of that box
    float plane, gx, gy;    ///< value at the centre, and slopes per texel
};

/// Level 0 has blocks of leaf_size x leaf_size texels; each level above joins 2 x 2; the last has one node.
class MaxPyramid {
  public:
    static constexpr int leaf_size = 4;

    struct Level {
        int width, height;
        std::vector<PyramidNode> nodes;
        const PyramidNode& at(int i, int j) const { return nodes[std::size_t(j) * width + i]; }
    };

    int level_count() const { return int(levels_.size()); }
    const Level& level(int k) const { return levels_[std::size_t(k)]; }

  private:
    friend MaxPyramid build_max_pyramid(const Image<float>& heights, int threads);
    std::vector<Level> levels_;
};

MaxPyramid build_max_pyramid(const Image<float>& heights, int threads);

} // namespace reliefbake

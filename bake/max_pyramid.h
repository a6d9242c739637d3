#pragma once
// A max pyramid whose nodes also carry a plane that lies on or above them (MATHS section 2, "Computing it fast").
// Straight flanks prune by the plane where the maximum alone would visit every node of the flank.

#include "bake/image.h"

#include <memory_resource>
#include <vector>

namespace reliefbake {

/// A plane's offset is moved away by this share of the heights it was computed from, more than float rounding can lose.
constexpr float plane_slack = 1e-6f;

/// One square of texels. Coordinates and distances are in texels; heights in the units of the input.
/// For every texel (x,y) of the node: height <= max and height <= plane + gx (x - cx) + gy (y - cy).
struct PyramidNode {
    float max;
    float cx, cy;           ///< centre of the box of its texels' centres
    float half_x, half_y;   ///< half extents of that box
    float plane, gx, gy;    ///< value at the centre, and slopes per texel
};

/// Four siblings in one cache line: (0,0), (1,0), (0,1), (1,1). One that lies outside the field has max = -inf.
struct alignas(64) PyramidQuad {
    float max[4], plane[4], gx[4], gy[4];
};

/// Level 0 has nodes of leaf_size x leaf_size texels; each level above joins 2 x 2; the last has one node.
class MaxPyramid {
  public:
    static constexpr int leaf_size = 4;

    int level_count() const { return int(levels_.size()); }
    /// Texels along one side of a node of level k that is not cut by the border.
    static int side(int k) { return leaf_size << k; }
    int nodes_x(int k) const { return (width_ + side(k) - 1) / side(k); }
    int nodes_y(int k) const { return (height_ + side(k) - 1) / side(k); }

    /// The children of node (i, j) of level k + 1.
    const PyramidQuad& quad(int k, int i, int j) const {
        const std::size_t quads_x = std::size_t(nodes_x(k) + 1) / 2;
        return levels_[std::size_t(k)][std::size_t(j) * quads_x + std::size_t(i)];
    }

    /// Centre and half extent of node i of level k along one axis of `count` texels.
    struct Span {
        float centre, half;
    };
    static Span span(int k, int i, int count) {
        const int first = i * side(k), last = (first + side(k) < count ? first + side(k) : count) - 1;
        return {0.5f * float(first + last), 0.5f * float(last - first)};
    }

    PyramidNode node(int k, int i, int j) const {
        const PyramidQuad& q = quad(k, i / 2, j / 2);
        const int c = (i & 1) + 2 * (j & 1);
        const Span x = span(k, i, width_), y = span(k, j, height_);
        return {q.max[c], x.centre, y.centre, x.half, y.half, q.plane[c], q.gx[c], q.gy[c]};
    }

  private:
    friend class PyramidBuilder;
    int width_ = 0, height_ = 0; ///< of the field, in texels
    std::vector<LargeArray<PyramidQuad>> levels_;
};

/// 1.4 bytes a texel, and 0.7 more while it is built, in `storage` (null: the heap).
MaxPyramid build_max_pyramid(const Image<float>& heights, int threads, std::pmr::memory_resource* storage = nullptr);

} // namespace reliefbake

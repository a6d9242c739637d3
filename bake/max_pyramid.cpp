#include "bake/max_pyramid.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {
namespace {

struct Box {
    int x0, y0, x1, y1; // texels, x1 and y1 exclusive
};

/// Centre and half extents of the texel centres in `box`.
void place(PyramidNode& node, Box box) {
    node.cx = 0.5f * float(box.x0 + box.x1 - 1);
    node.cy = 0.5f * float(box.y0 + box.y1 - 1);
    node.half_x = 0.5f * float(box.x1 - 1 - box.x0);
    node.half_y = 0.5f * float(box.y1 - 1 - box.y0);
}

PyramidNode leaf_node(const Image<float>& heights, Box box, double& mean) {
    PyramidNode node{};
    place(node, box);
    // Least squares on a regular grid: the slope is the covariance over the variance, axis by axis.
    float low = heights(box.x0, box.y0), high = low;
    double sum = 0, cov_x = 0, cov_y = 0, var_x = 0, var_y = 0;
    for (int y = box.y0; y < box.y1; ++y) {
        for (int x = box.x0; x < box.x1; ++x) {
            const float h = heights(x, y), dx = float(x) - node.cx, dy = float(y) - node.cy;
            low = std::min(low, h);
            high = std::max(high, h);
            sum += h;
            cov_x += double(dx) * h, var_x += double(dx) * dx;
            cov_y += double(dy) * h, var_y += double(dy) * dy;
        }
    }
    mean = sum / (double(box.x1 - box.x0) * (box.y1 - box.y0));
    node.max = high;
    node.gx = var_x > 0 ? float(cov_x / var_x) : 0.0f;
    node.gy = var_y > 0 ? float(cov_y / var_y) : 0.0f;
    // Raise the plane until no texel lies above it.
    float offset = -std::numeric_limits<float>::infinity();
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
            offset = std::max(offset, heights(x, y) - (node.gx * (float(x) - node.cx) + node.gy * (float(y) - node.cy)));
    node.plane = offset + plane_slack * std::max(std::fabs(low), std::fabs(high));
    return node;
}

/// Least offset of a plane with the parent's slopes above the child's own bounds.
float offset_above(const PyramidNode& parent, const PyramidNode& child) {
    const float dx = child.cx - parent.cx, dy = child.cy - parent.cy;
    const float at_centre = parent.gx * dx + parent.gy * dy;
    const float by_plane = child.plane - at_centre + std::fabs(child.gx - parent.gx) * child.half_x +
                           std::fabs(child.gy - parent.gy) * child.half_y;
    const float by_max = child.max - at_centre + std::fabs(parent.gx) * child.half_x + std::fabs(parent.gy) * child.half_y;
    return std::min(by_plane, by_max);
}

/// Number of texels of a node, and the variance of their x (or y) times that number.
double texel_count(const PyramidNode& n) { return (2.0 * n.half_x + 1) * (2.0 * n.half_y + 1); }
double variance_sum(const PyramidNode& n, float half) {
    const double side = 2.0 * half + 1;
    return texel_count(n) * (side * side - 1) / 12;
}

/// Least squares over the texels of all children: covariances add up, within the children and between their means.
void fit_slopes(PyramidNode& node, const PyramidNode* const* children, const double* means, int count) {
    double n = 0, mean = 0;
    for (int k = 0; k < count; ++k) n += texel_count(*children[k]), mean += texel_count(*children[k]) * means[k];
    mean /= n;
    double cov_x = 0, cov_y = 0, var_x = 0, var_y = 0;
    for (int k = 0; k < count; ++k) {
        const PyramidNode& c = *children[k];
        const double nc = texel_count(c), dx = c.cx - node.cx, dy = c.cy - node.cy, dh = means[k] - mean;
        cov_x += c.gx * variance_sum(c, c.half_x) + nc * dx * dh, var_x += variance_sum(c, c.half_x) + nc * dx * dx;
        cov_y += c.gy * variance_sum(c, c.half_y) + nc * dy * dh, var_y += variance_sum(c, c.half_y) + nc * dy * dy;
    }
    node.gx = var_x > 0 ? float(cov_x / var_x) : 0.0f;
    node.gy = var_y > 0 ? float(cov_y / var_y) : 0.0f;
}

void join(const PyramidNode* const* children, const double* means, int count, PyramidNode& node, double& mean) {
    // Join boxes, maxima and means.
    float x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY, largest = 0;
    double n = 0;
    node.max = -INFINITY, mean = 0;
    for (int k = 0; k < count; ++k) {
        const PyramidNode& c = *children[k];
        x0 = std::min(x0, c.cx - c.half_x), x1 = std::max(x1, c.cx + c.half_x);
        y0 = std::min(y0, c.cy - c.half_y), y1 = std::max(y1, c.cy + c.half_y);
        node.max = std::max(node.max, c.max);
        largest = std::max({largest, std::fabs(c.max), std::fabs(c.plane)});
        n += texel_count(c), mean += texel_count(c) * means[k];
    }
    mean /= n;
    node.cx = 0.5f * (x0 + x1), node.cy = 0.5f * (y0 + y1);
    node.half_x = 0.5f * (x1 - x0), node.half_y = 0.5f * (y1 - y0);
    // Fit the slopes, then raise the plane above every child's bounds.
    fit_slopes(node, children, means, count);
    float offset = -INFINITY;
    for (int k = 0; k < count; ++k) offset = std::max(offset, offset_above(node, *children[k]));
    const float tilt = std::fabs(node.gx) * node.half_x + std::fabs(node.gy) * node.half_y;
    node.plane = offset + plane_slack * (largest + tilt);
}

} // namespace

/// Level by level from the leaves. Besides the nodes only their mean heights are kept, until the level above is made.
class PyramidBuilder {
  public:
    PyramidBuilder(const Image<float>& heights, int threads, std::pmr::memory_resource* storage)
        : heights_(heights), threads_(threads), storage_(storage) {
        pyramid_.width_ = heights.width(), pyramid_.height_ = heights.height();
    }

    MaxPyramid build() {
        add_level([&](int i, int j, double& mean) {
            constexpr int s = MaxPyramid::leaf_size;
            return leaf_node(heights_, {i * s, j * s, std::min(i * s + s, heights_.width()), std::min(j * s + s, heights_.height())}, mean);
        });
        while (nodes_x() * nodes_y() > 1) {
            const LargeArray<double> below = std::move(means_);
            const int level = pyramid_.level_count() - 1;
            add_level([&](int i, int j, double& mean) { return node_above(level, below, i, j, mean); });
        }
        return std::move(pyramid_);
    }

  private:
    std::size_t nodes_x() const { return std::size_t(pyramid_.nodes_x(pyramid_.level_count() - 1)); }
    std::size_t nodes_y() const { return std::size_t(pyramid_.nodes_y(pyramid_.level_count() - 1)); }

    /// make(i, j, mean): the node (i, j) of the new level.
    template <class Make>
    void add_level(const Make& make) {
        PyramidQuad outside{};
        std::fill(std::begin(outside.max), std::end(outside.max), -INFINITY);
        const int level = pyramid_.level_count(), width = pyramid_.nodes_x(level), height = pyramid_.nodes_y(level);
        const std::size_t quads_x = (std::size_t(width) + 1) / 2, quads_y = (std::size_t(height) + 1) / 2;
        LargeArray<PyramidQuad> quads(quads_x * quads_y, outside, LargeAllocator<PyramidQuad>(storage_));
        LargeArray<double> means(std::size_t(width) * std::size_t(height), LargeAllocator<double>(storage_));
        parallel_for(height, threads_, [&](int j) {
            for (int i = 0; i < width; ++i) {
                const PyramidNode n = make(i, j, means[std::size_t(j) * std::size_t(width) + std::size_t(i)]);
                PyramidQuad& q = quads[std::size_t(j / 2) * quads_x + std::size_t(i / 2)];
                const int c = (i & 1) + 2 * (j & 1);
                q.max[c] = n.max, q.plane[c] = n.plane, q.gx[c] = n.gx, q.gy[c] = n.gy;
            }
        });
        pyramid_.levels_.push_back(std::move(quads));
        means_ = std::move(means);
    }

    PyramidNode node_above(int level, const LargeArray<double>& below, int i, int j, double& mean) const {
        const int width = pyramid_.nodes_x(level), height = pyramid_.nodes_y(level);
        PyramidNode nodes[4];
        const PyramidNode* children[4];
        double means[4];
        int count = 0;
        for (int cj = 2 * j; cj < std::min(2 * j + 2, height); ++cj)
            for (int ci = 2 * i; ci < std::min(2 * i + 2, width); ++ci) {
                nodes[count] = pyramid_.node(level, ci, cj), children[count] = &nodes[count];
                means[count++] = below[std::size_t(cj) * std::size_t(width) + std::size_t(ci)];
            }
        PyramidNode node{};
        join(children, means, count, node, mean);
        return node;
    }

    const Image<float>& heights_;
    const int threads_;
    std::pmr::memory_resource* const storage_;
    MaxPyramid pyramid_;
    LargeArray<double> means_;
};

MaxPyramid build_max_pyramid(const Image<float>& heights, int threads, std::pmr::memory_resource* storage) {
    return PyramidBuilder(heights, threads, storage).build();
}

} // namespace reliefbake

#include "shaders-reference/measure/adversarial_points.h"

#include "shaders-reference/oracle/steepest_texel.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr std::size_t steep_cell_count = 256;
constexpr double full_turn = 6.283185307179586;
constexpr double off_edge = 1e-6; ///< texels

struct SteepCell {
    float rise;
    int i, j;
};

std::vector<SteepCell> steepest_cells(const BilinearSurface& surface) {
    const TexelGrid& grid = surface.grid();
    std::vector<SteepCell> cells;
    cells.reserve(std::size_t(grid.width) * std::size_t(grid.height));
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
            const Patch p = surface.patch(i, j);
            cells.push_back({float(p.highest() - std::min(std::min(p.h00, p.h10), std::min(p.h01, p.h11))), i, j});
        }
    const auto steeper = [](const SteepCell& a, const SteepCell& b) {
        if (a.rise != b.rise) return a.rise > b.rise;
        return a.j != b.j ? a.j < b.j : a.i < b.i;
    };
    const std::size_t kept = std::min(steep_cell_count, cells.size());
    std::partial_sort(cells.begin(), cells.begin() + std::ptrdiff_t(kept), cells.end(), steeper);
    cells.resize(kept);
    return cells;
}

} // namespace

AdversarialPoints::AdversarialPoints(const BilinearSurface& surface) : surface_(surface) {
    for (const SteepCell& cell : steepest_cells(surface)) steep_cells_.push_back({double(cell.i), double(cell.j)});
}

MapPoint AdversarialPoints::at(double x, double y) const {
    return {(x + 0.5) / surface_.grid().width, (y + 0.5) / surface_.grid().height};
}

MapPoint AdversarialPoints::near_minimum(SplitMix& random) const {
    // Walk downhill over texels, then stay within half a texel.
    const TexelGrid& grid = surface_.grid();
    std::int64_t i = random.below(grid.width);
    std::int64_t j = random.below(grid.height);
    for (bool moved = true; moved;) {
        moved = false;
        const std::int64_t centre_i = i, centre_j = j;
        for (std::int64_t b = centre_j - 1; b <= centre_j + 1; ++b)
            for (std::int64_t a = centre_i - 1; a <= centre_i + 1; ++a)
                if (surface_.texel(a, b) < surface_.texel(i, j)) {
                    i = a;
                    j = b;
                    moved = true;
                }
    }
    return at(double(i) + random.uniform() - 0.5, double(j) + random.uniform() - 0.5);
}

MapPoint AdversarialPoints::draw(std::uint64_t index, SplitMix& random) const {
    const double i = random.below(surface_.grid().width);
    const double j = random.below(surface_.grid().height);
    const double along = random.uniform();
    const bool upright = random.below(2) == 0;
    switch (index % 7) {
    case 0: return {random.uniform(), random.uniform()};
    case 1: return at(i, j);
    case 2: return at(i + 0.5, j + 0.5);
    case 3: return upright ? at(i, j + along) : at(i + along, j);
    case 4: {
        const double off = random.below(2) == 0 ? off_edge : -off_edge;
        return upright ? at(i + off, j + along) : at(i + along, j + off);
    }
    case 5: {
        const MapPoint& cell = steep_cells_[std::size_t(random.below(int(steep_cells_.size())))];
        // Just inside the rim: the gradient at a corner holds towards every side, but only for points within the cell.
        constexpr double places[] = {off_edge, 0.25, 0.5, 0.75, 1 - off_edge};
        return at(cell.u + places[random.below(5)], cell.v + places[random.below(5)]);
    }
    default: return near_minimum(random);
    }
}

void adversarial_headings(const BilinearSurface& surface, const MapPoint& point, double ratio, Metric metric,
                          SplitMix& random, std::vector<Heading>& headings) {
    const TexelGrid& grid = surface.grid();
    headings.clear();
    for (int k = 0; k < 8; ++k) headings.push_back(Heading::from_angle(full_turn * k / 8));
    for (int k = 0; k < 6; ++k) headings.push_back(Heading::from_angle(full_turn * random.uniform()));

    // Towards the 16 texels around the cell.
    const double x = surface.to_x(point.u), y = surface.to_y(point.v);
    const double i = std::floor(x), j = std::floor(y);
    for (int b = -1; b <= 2; ++b)
        for (int a = -1; a <= 2; ++a) {
            const double du = (i + a - x) / grid.width, dv = (j + b - y) / grid.height;
            if (du != 0 || dv != 0) headings.push_back(Heading::along(grid, du, dv));
        }

    // Up the gradient of the cell and of its neighbours (the point may lie on an edge).
    for (int b = -1; b <= 1; ++b)
        for (int a = -1; a <= 1; ++a) {
            const Patch patch = surface.patch(std::int64_t(i) + a, std::int64_t(j) + b);
            const double gx = patch.slope(x - i - a, y - j - b, 1, 0) / grid.pitch_x();
            const double gy = patch.slope(x - i - a, y - j - b, 0, 1) / grid.pitch_y();
            const double norm = std::hypot(gx, gy);
            if (norm > 0) headings.push_back({gx / norm, gy / norm});
        }

    // Towards the texel that limits the cone, and to either side of it.
    constexpr double promising = 0.7; // of what would break the cone
    constexpr double least = 1e-9;    // slope, when the cone has no bound
    if (ratio <= 0) return;
    const SteepestTexel limit = steepest_texel(surface, point.u, point.v, metric, std::max(promising / ratio, least));
    if (limit.slope <= 0) return;
    for (const double aside : {0.0, -0.5, 0.5, -0.1, 0.1}) {
        const Heading straight = Heading::along(grid, limit.du, limit.dv);
        headings.push_back(Heading::along(grid, limit.du - aside * straight.y / grid.width,
                                          limit.dv + aside * straight.x / grid.height));
    }
}

} // namespace reliefbake

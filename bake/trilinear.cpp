#include "bake/trilinear.h"

#include <algorithm>
#include <vector>

namespace reliefbake {

// Let H = (1-f) H0 + f H1 be the blend of two levels. If r holds at x for both surfaces, it holds for H:
//
//     H(y) - H(x) = (1-f) (H0(y) - H0(x)) + f (H1(y) - H1(x)) <= |y-x| / r.
//
// The sampled code at x is a mean of the codes of both levels' corner texels, so it decodes to the largest of their ratios
// at most. A texel's cone holds by itself wherever the texel has any weight (its footprint: the cells that touch its
// centre; guarantee C under filtering). So the blend is safe if every stored ratio holds for the *other* level too, over
// the texel's own footprint. There, in a cell of the other level, each of that cell's four corners is a ratio that holds: the
// widest of them may be taken. Hence
//
//     +---------------------------------------------------------------------------------------------+
//     | r(a) <- min( r(a), min over cells of the adjacent levels that meet a's footprint of the max  |
//     |              over the cell's corners )                                                       |
//     +---------------------------------------------------------------------------------------------+
//
// from the ratios as baked: nothing needs to travel further than one level, since a blend never mixes three.

namespace {

/// First and last cell, along one axis of `other` texels, that meet the footprint of texel i of `count`. Cell k lies between
/// the centres of texels k and k + 1. Footprint: [(i - 1/2) / count, (i + 3/2) / count]; cell: [(k + 1/2) / other,
/// (k + 3/2) / other]. Touching counts as meeting: a sampler may round a weight of 0 up.
struct CellRange {
    int first, last;
};

int floor_div(long long a, long long b) { return int(a >= 0 ? a / b : -((-a + b - 1) / b)); }

CellRange cells_under(int i, int count, int other) {
    const long long n = count, m = other;
    const int first = -floor_div(-((2LL * i - 1) * m - 3 * n), 2 * n); // (2k + 3) n >= (2i - 1) m
    const int last = floor_div((2LL * i + 3) * m - n, 2 * n);          // (2k + 1) n <= (2i + 3) m
    return {first, last};
}

/// Beyond the first and last centre a clamped surface is constant across the border: those cells have both corners there.
float widest_corner(const ConeMap& map, int k, int l) {
    const TexelGrid& grid = map.grid;
    const int x0 = grid.address_x(k), x1 = grid.address_x(k + 1), y0 = grid.address_y(l), y1 = grid.address_y(l + 1);
    return std::max(std::max(map.ratio(x0, y0), map.ratio(x1, y0)), std::max(map.ratio(x0, y1), map.ratio(x1, y1)));
}

/// The widest ratio that holds for `other` over the footprint of texel (i, j) of `grid`.
float ratio_over_footprint(const TexelGrid& grid, int i, int j, const ConeMap& other) {
    const CellRange across = cells_under(i, grid.width, other.grid.width);
    const CellRange down = cells_under(j, grid.height, other.grid.height);
    float least = widest_corner(other, across.first, down.first);
    for (int l = down.first; l <= down.last; ++l)
        for (int k = across.first; k <= across.last; ++k) least = std::min(least, widest_corner(other, k, l));
    return least;
}

} // namespace

void narrow_for_trilinear(std::span<ConeMap> levels) {
    const std::vector<ConeMap> baked(levels.begin(), levels.end());
    for (std::size_t n = 0; n < levels.size(); ++n) {
        const TexelGrid& grid = levels[n].grid;
        for (int j = 0; j < grid.height; ++j)
            for (int i = 0; i < grid.width; ++i) {
                float& ratio = levels[n].ratio(i, j);
                if (n > 0) ratio = std::min(ratio, ratio_over_footprint(grid, i, j, baked[n - 1]));
                if (n + 1 < levels.size()) ratio = std::min(ratio, ratio_over_footprint(grid, i, j, baked[n + 1]));
            }
    }
}

} // namespace reliefbake

#include "shaders-reference/oracle/exact_cone.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reliefbake {
namespace {

struct Vector {
    Rational x, y;
};

/// A box of a cell, in texels of that cell: [x0, x1] x [y0, y1] of [0, 1]^2.
struct Box {
    Rational x0, y0, x1, y1;
    int halvings = 0;
};

/// A box halved this often is 2^-40 of a texel: what is not cleared then touches the cone.
constexpr int most_halvings = 40;

/// One cell as the apex sees it: rises above it at the corners, and the way to its corner 00, in texel widths.
struct SeenCell {
    Rational r00, r10, r01, r11;
    Vector corner;
    Rational aspect; ///< height of a texel over its width
    bool own;        ///< the apex lies in it, borders included

    Rational rise(const Rational& x, const Rational& y) const {
        return r00 + (r10 - r00) * x + (r01 - r00) * y + (r00 - r10 - r01 + r11) * x * y;
    }
    Vector way(const Rational& x, const Rational& y) const { return {corner.x + x, corner.y + y * aspect}; }
    Vector gradient(const Rational& x, const Rational& y) const {
        const Rational twist = r00 - r10 - r01 + r11;
        return {r10 - r00 + twist * y, (r01 - r00 + twist * x) / aspect};
    }
};

/// The cone in texel widths per level; `above` >= ratio, `squared` its exact square.
struct Slimness {
    Rational squared, above;
    Metric metric;
};

Rational norm_squared(const Vector& d, Metric metric) {
    if (metric == Metric::l2) return d.x * d.x + d.y * d.y;
    const Rational sum = abs(d.x) + abs(d.y);
    return sum * sum;
}

/// Squared length of a gradient as seen per unit of distance: the dual norm.
Rational steepness_squared(const Vector& g, Metric metric) {
    if (metric == Metric::l2) return g.x * g.x + g.y * g.y;
    const Rational most = std::max(Rational(abs(g.x)), Rational(abs(g.y)));
    return most * most;
}

bool is_inside(const SeenCell& cell, const Slimness& cone, const Rational& x, const Rational& y) {
    const Rational rise = cell.rise(x, y);
    return rise > 0 && cone.squared * rise * rise > norm_squared(cell.way(x, y), cone.metric);
}

/// A vector towards (x, y) of length at most 1, in l1 of components at most 1.
Vector unit_below(const Vector& way, Metric metric) {
    const double x = double(way.x), y = double(way.y);
    if (metric == Metric::l1) return {x > 0 ? 1 : x < 0 ? -1 : 0, y > 0 ? 1 : y < 0 ? -1 : 0};
    const double length = std::hypot(x, y);
    if (!(length > 0)) return {0, 0};
    Vector u{exactly(x / length), exactly(y / length)};
    while (u.x * u.x + u.y * u.y > 1) u = {u.x * exactly(1 - 0x1p-50), u.y * exactly(1 - 0x1p-50)};
    return u;
}

std::array<std::array<Rational, 2>, 4> corners(const Box& box) {
    return {{{box.x0, box.y0}, {box.x1, box.y0}, {box.x0, box.y1}, {box.x1, box.y1}}};
}

bool is_cleared_by_gradient(const SeenCell& cell, const Slimness& cone, const Box& box) {
    // Where the apex is in this cell's coordinates.
    const Rational px = -cell.corner.x, py = -cell.corner.y / cell.aspect;
    for (const auto& [x, y] : corners(box))
        if (cone.squared * steepness_squared(cell.gradient((x + px) / 2, (y + py) / 2), cone.metric) > 1) return false;
    return true;
}

bool is_cleared_along(const SeenCell& cell, const Slimness& cone, const Box& box, const Vector& u) {
    for (const auto& [x, y] : corners(box)) {
        const Vector d = cell.way(x, y);
        if (cone.above * cell.rise(x, y) > u.x * d.x + u.y * d.y) return false;
    }
    return true;
}

/// Towards the box where a peak in it limits the cone; up its gradient where a straight flank does.
bool is_cleared(const SeenCell& cell, const Slimness& cone, const Box& box) {
    if (cell.own && is_cleared_by_gradient(cell, cone, box)) return true;
    const Rational x = (box.x0 + box.x1) / 2, y = (box.y0 + box.y1) / 2;
    return is_cleared_along(cell, cone, box, unit_below(cell.way(x, y), cone.metric)) ||
           is_cleared_along(cell, cone, box, unit_below(cell.gradient(x, y), cone.metric));
}

/// Short chords up the gradient at the apex, if they lead into the cell.
bool is_convicted_by_gradient(const SeenCell& cell, const Slimness& cone) {
    const Rational px = -cell.corner.x, py = -cell.corner.y / cell.aspect;
    const Vector g = cell.gradient(px, py);
    const bool leads_in = (g.x > 0 ? px < 1 : g.x < 0 ? px > 0 : true) && (g.y > 0 ? py < 1 : g.y < 0 ? py > 0 : true);
    return leads_in && cone.squared * steepness_squared(g, cone.metric) > 1;
}

void judge_cell(const SeenCell& cell, const Slimness& cone, std::uint64_t most_boxes, ExactJudgement& result) {
    if (cell.own && is_convicted_by_gradient(cell, cone)) {
        result.verdict = ExactVerdict::violated;
        return;
    }
    std::vector<Box> open{{0, 0, 1, 1, 0}};
    while (!open.empty()) {
        const Box box = std::move(open.back());
        open.pop_back();
        if (++result.boxes > most_boxes || box.halvings > most_halvings) {
            result.verdict = ExactVerdict::undecided;
            return;
        }
        if (is_cleared(cell, cone, box)) continue;
        for (const auto& [x, y] : corners(box))
            if (is_inside(cell, cone, x, y)) {
                result.verdict = ExactVerdict::violated;
                return;
            }
        const Rational x = (box.x0 + box.x1) / 2, y = (box.y0 + box.y1) / 2;
        for (Box part : {Box{box.x0, box.y0, x, y}, Box{x, box.y0, box.x1, y}, Box{box.x0, y, x, box.y1}, Box{x, y, box.x1, box.y1}}) {
            part.halvings = box.halvings + 1;
            open.push_back(std::move(part));
        }
    }
}

/// The square root, or a number above it by less than 2^-60 of it.
Rational root_above(const Rational& squared) {
    const Rational exact(sqrt(numerator(squared)), sqrt(denominator(squared)));
    if (exact * exact == squared) return exact;
    const double guess = std::sqrt(double(squared));
    Rational above = exactly(guess);
    for (const Rational step = exactly(guess * 0x1p-50); above * above < squared; above += step) {}
    return (above + squared / above) / 2; // Newton's step from above stays above
}

Slimness slimness(const Rational& ratio_squared, const ExactSurface& surface, Metric metric) {
    const Rational unit = Rational(surface.grid().width) / surface.levels();
    const Rational squared = ratio_squared * unit * unit;
    return {squared, root_above(squared), metric};
}

/// Least distance from the apex to a cell, in texel widths, a hair too small.
double least_distance(double x, double y, double aspect, int i, int j, Metric metric) {
    const double dx = std::max({0.0, i - x, x - i - 1}), dy = aspect * std::max({0.0, j - y, y - j - 1});
    return (metric == Metric::l1 ? dx + dy : std::hypot(dx, dy)) * (1 - 1e-9);
}

} // namespace

Rational exactly(double value) { return Rational(value); }

ExactSurface::ExactSurface(const DepthMap& depth)
    : grid_(depth.grid), rises_(depth.level), highest_(0), levels_(max_code(depth.bits)) {
    for (float& level : rises_) level = -level;
    highest_ = *std::max_element(rises_.begin(), rises_.end());
}

ExactJudgement judge_exactly(const ExactSurface& surface, HalfTexel apex, const std::optional<Rational>& ratio_squared, Metric metric,
                             std::uint64_t most_boxes) {
    const TexelGrid& grid = surface.grid();
    const int left = apex.x >> 1, top = apex.y >> 1, right = left + (apex.x & 1), below = top + (apex.y & 1);
    const Rational apex_rise = (exactly(surface.rise(left, top)) + exactly(surface.rise(right, top)) + exactly(surface.rise(left, below)) +
                                exactly(surface.rise(right, below))) / 4;
    ExactJudgement result;
    if (!ratio_squared) {
        if (exactly(surface.highest()) > apex_rise) result.verdict = ExactVerdict::violated;
        return result;
    }
    if (*ratio_squared == 0) return result;
    const Slimness cone = slimness(*ratio_squared, surface, metric);
    const double x = apex.x / 2.0, y = apex.y / 2.0, base = double(apex_rise), wide = double(cone.above) * (1 + 1e-9);
    const double reach = wide * (surface.highest() - base + 1e-12 * surface.levels());
    const auto span = [reach](double centre, double pitch, int count, Wrap wrap) {
        // Of a repeated point the nearest copy decides; beyond a clamped border stand the border's heights, farther away.
        const double far = std::min(reach / pitch, wrap == Wrap::repeat ? count / 2.0 : double(count));
        int low = int(std::floor(centre - far)) - 1, high = int(std::floor(centre + far)) + 1;
        if (wrap == Wrap::clamp) low = std::max(low, 0), high = std::min(high, std::max(0, count - 2));
        return std::pair(low, high);
    };
    const auto [i0, i1] = span(x, 1, grid.width, grid.wrap_x);
    const auto [j0, j1] = span(y, grid.pixel_aspect, grid.height, grid.wrap_y);
    for (int j = j0; j <= j1; ++j)
        for (int i = i0; i <= i1; ++i) {
            const double peak = std::max({surface.rise(i, j), surface.rise(i + 1, j), surface.rise(i, j + 1), surface.rise(i + 1, j + 1)});
            // Doubles clear what is far from touching: their error is below 1e-12 of a height, and 1e-9 is left for the rest.
            if (wide * (peak - base + 1e-12 * surface.levels()) < least_distance(x, y, grid.pixel_aspect, i, j, metric)) continue;
            const auto seen = [&](int a, int b) { return Rational(exactly(surface.rise(a, b)) - apex_rise); };
            const Rational aspect = exactly(grid.pixel_aspect);
            const SeenCell cell{seen(i, j), seen(i + 1, j), seen(i, j + 1), seen(i + 1, j + 1),
                                {Rational(2 * i - apex.x) / 2, Rational(2 * j - apex.y) * aspect / 2}, aspect,
                                apex.x >= 2 * i && apex.x <= 2 * i + 2 && apex.y >= 2 * j && apex.y <= 2 * j + 2};
            judge_cell(cell, cone, most_boxes, result);
            if (result.verdict != ExactVerdict::holds) return result;
        }
    return result;
}

} // namespace reliefbake

#include "bake/horizon_map.h"

#include "bake/line_horizons.h"
#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace reliefbake {

namespace {

/// A walk over texel centres: `seen` texels of the map, each on one line alone, and as many more steps as hold all that can
/// be seen from them.
struct Line {
    int x, y; ///< first texel
    std::int64_t seen, total;
};

/// Lines along an axis. On a repeated one, a texel sees one period ahead: beyond, the same heights are farther away.
std::vector<Line> axis_lines(const TexelGrid& grid, int dx, int dy) {
    const int along = dx != 0 ? grid.width : grid.height, across = dx != 0 ? grid.height : grid.width;
    const bool repeats = (dx != 0 ? grid.wrap_x : grid.wrap_y) == Wrap::repeat;
    const int start = dx + dy > 0 ? 0 : along - 1;
    std::vector<Line> lines;
    for (int i = 0; i < across; ++i)
        lines.push_back({dx != 0 ? start : i, dx != 0 ? i : start, along, repeats ? 2 * std::int64_t(along) : along});
    return lines;
}

/// Diagonals. Where an axis is clamped, a line goes on beyond the border, over the border's texels.
std::vector<Line> diagonal_lines(const TexelGrid& grid, int dx, int dy) {
    const int w = grid.width, h = grid.height;
    const bool repeats_x = grid.wrap_x == Wrap::repeat, repeats_y = grid.wrap_y == Wrap::repeat;
    const int start_x = dx > 0 ? 0 : w - 1, start_y = dy > 0 ? 0 : h - 1;
    const auto column = [&](int k) { return start_x + dx * k; };
    const auto row = [&](int k) { return start_y + dy * k; };
    std::vector<Line> lines;
    if (repeats_x && repeats_y) {
        // Closed orbits.
        const int orbits = std::gcd(w, h);
        const std::int64_t length = std::int64_t(w) / orbits * h;
        for (int k = 0; k < orbits; ++k) lines.push_back({column(k), row(0), length, 2 * length});
    } else if (repeats_y) {
        for (int k = 0; k < h; ++k) lines.push_back({column(0), row(k), w, std::int64_t(w) + h});
    } else if (repeats_x) {
        for (int k = 0; k < w; ++k) lines.push_back({column(k), row(0), h, std::int64_t(h) + w});
    } else {
        for (int k = 0; k < h; ++k) lines.push_back({column(0), row(k), std::min(w, h - k), std::max(w, h - k)});
        for (int k = 1; k < w; ++k) lines.push_back({column(k), row(0), std::min(w - k, h), std::max(w - k, h)});
    }
    return lines;
}

/// A coordinate that walks backwards, and the texel that it stands for.
class BackwardWalk {
  public:
    BackwardWalk(std::int64_t start, int step, std::int64_t steps, int count, Wrap wrap)
        : at_(start + step * steps), step_(step), count_(count), repeats_(wrap == Wrap::repeat) {
        if (repeats_) at_ = (at_ % count + count) % count;
    }
    int texel() const { return int(repeats_ ? at_ : std::clamp<std::int64_t>(at_, 0, count_ - 1)); }
    void step_back() {
        at_ -= step_;
        if (repeats_ && at_ < 0) at_ += count_;
        if (repeats_ && at_ >= count_) at_ -= count_;
    }

  private:
    std::int64_t at_;
    int step_, count_;
    bool repeats_;
};

/// Heights, as negated levels, of the bilinear surface along one line, step by step from its far end.
class LineCurve {
  public:
    LineCurve(const DepthMap& depth, const Line& line, int dx, int dy)
        : depth_(depth), x_(line.x, dx, line.total, depth.grid.width, depth.grid.wrap_x),
          y_(line.y, dy, line.total, depth.grid.height, depth.grid.wrap_y) {}

    /// H(t) = h00 + (h10 - h00 + h01 - h00) t + (h00 - h10 - h01 + h11) t^2 across a cell from corner to corner; on an axis
    /// two corners fall together and a straight piece is left.
    CurveStep operator()(std::int64_t) {
        const int x1 = x_.texel(), y1 = y_.texel();
        x_.step_back();
        y_.step_back();
        x = x_.texel(), y = y_.texel();
        const double h00 = height(x, y), h10 = height(x1, y), h01 = height(x, y1), h11 = height(x1, y1);
        return {h00, (h10 - h00) + (h01 - h00), (h00 - h10) + (h11 - h01)};
    }
    int x = 0, y = 0; ///< texel from which the last step goes

  private:
    double height(int i, int j) const { return -double(depth_.level(i, j)); }

    const DepthMap& depth_;
    BackwardWalk x_, y_;
};

double step_length(const TexelGrid& grid, int dx, int dy) {
    if (dx == 0) return grid.pitch_y();
    if (dy == 0) return grid.pitch_x();
    return std::sqrt(grid.pitch_x() * grid.pitch_x() + grid.pitch_y() * grid.pitch_y());
}

Image<float> bake_azimuth(const DepthMap& depth, double depth_scale, int dx, int dy, int threads) {
    const TexelGrid& grid = depth.grid;
    const std::vector<Line> lines = dx != 0 && dy != 0 ? diagonal_lines(grid, dx, dy) : axis_lines(grid, dx, dy);
    const double tangent_of_slope = depth_scale / (max_code(depth.bits) * step_length(grid, dx, dy));
    Image<float> sine(grid.width, grid.height);
    parallel_for(int(lines.size()), threads, [&](int k) {
        const Line& line = lines[std::size_t(k)];
        LineCurve curve(depth, line, dx, dy);
        line_horizons(line.seen, line.total, curve, [&](std::int64_t, double slope) {
            const double tangent = slope * tangent_of_slope;
            sine(curve.x, curve.y) = float(tangent / std::sqrt(1 + tangent * tangent));
        });
    });
    return sine;
}

} // namespace

double horizon_angle(const TexelGrid& grid, int k) {
    constexpr double half_turn = 3.14159265358979323846;
    const auto [dx, dy] = horizon_steps[std::size_t(k)];
    const double angle = std::atan2(dy * grid.pitch_y(), dx * grid.pitch_x());
    return angle < 0 ? angle + 2 * half_turn : angle;
}

HorizonMap bake_horizons(const DepthMap& depth, double depth_scale, int threads) {
    HorizonMap map{depth.grid, depth_scale, {}};
    for (const auto& [dx, dy] : horizon_steps) map.sine.push_back(bake_azimuth(depth, depth_scale, dx, dy, threads));
    return map;
}

double horizon_error(BitDepth bits) {
    constexpr double float_rounding = 0x1p-24;
    if (is_unorm(bits)) return 0.5 / max_code(bits) + 2 * float_rounding;
    return bits == BitDepth::half ? 0x1p-12 + 2 * float_rounding : 2 * float_rounding;
}

} // namespace reliefbake

#include "tests/support/height_distances.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace reliefbake::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// min over q of |q - p| pitch + value[q]
std::vector<double> chamfer(std::vector<double> value, double pitch) {
    const std::size_t n = value.size();
    for (std::size_t p = 1; p < n; ++p) value[p] = std::min(value[p], value[p - 1] + pitch);
    for (std::size_t p = n - 1; p-- > 0;) value[p] = std::min(value[p], value[p + 1] + pitch);
    return value;
}

/// min over q of ((q - p) pitch)^2 + value[q], as the lower envelope of the parabolas of q.
std::vector<double> envelope(const std::vector<double>& value, double pitch) {
    const double p2 = pitch * pitch;
    const auto parabola = [&](int q, int p) { return double(q - p) * double(q - p) * p2 + value[std::size_t(q)]; };
    std::vector<int> lowest;   // parabolas of the envelope, from left to right
    std::vector<double> start; // where each begins
    for (int q = 0; q < int(value.size()); ++q) {
        if (std::isinf(value[std::size_t(q)])) continue;
        double from = -infinity;
        while (!lowest.empty()) {
            const int v = lowest.back();
            from = 0.5 * (q + v) + (value[std::size_t(q)] - value[std::size_t(v)]) / (2 * p2 * (q - v));
            if (from > start.back()) break;
            lowest.pop_back(), start.pop_back();
            from = -infinity;
        }
        lowest.push_back(q), start.push_back(from);
    }
    std::vector<double> out(value.size(), infinity);
    std::size_t k = 0;
    for (int p = 0; p < int(value.size()) && !lowest.empty(); ++p) {
        while (k + 1 < lowest.size() && start[k + 1] <= p) ++k;
        out[std::size_t(p)] = parabola(lowest[k], p);
    }
    return out;
}

/// One axis of the transform; repeated axes are laid out three times, and the middle counts.
std::vector<double> along(const std::vector<double>& line, double pitch, Wrap wrap, Metric metric) {
    std::vector<double> tiles = line;
    if (wrap == Wrap::repeat)
        for (int k = 0; k < 2; ++k) tiles.insert(tiles.end(), line.begin(), line.end());
    const std::vector<double> out = metric == Metric::l1 ? chamfer(tiles, pitch) : envelope(tiles, pitch);
    const auto first = out.begin() + (wrap == Wrap::repeat ? std::ptrdiff_t(line.size()) : 0);
    return {first, first + std::ptrdiff_t(line.size())};
}

} // namespace

Image<double> distance_transform(const Image<char>& set, const TexelGrid& grid, Metric metric) {
    Image<double> out(grid.width, grid.height);
    std::vector<double> line(std::size_t(grid.height));
    for (int i = 0; i < grid.width; ++i) {
        for (int j = 0; j < grid.height; ++j) line[std::size_t(j)] = set(i, j) ? 0 : infinity;
        const std::vector<double> column = along(line, grid.pitch_y(), grid.wrap_y, metric);
        for (int j = 0; j < grid.height; ++j) out(i, j) = column[std::size_t(j)];
    }
    for (int j = 0; j < grid.height; ++j) {
        const std::vector<double> row = along({out.row(j), out.row(j) + grid.width}, grid.pitch_x(), grid.wrap_x, metric);
        for (int i = 0; i < grid.width; ++i) out(i, j) = metric == Metric::l1 ? row[std::size_t(i)] : std::sqrt(row[std::size_t(i)]);
    }
    return out;
}

HeightDistances::HeightDistances(const DepthMap& depth, Metric metric) : depth_(depth) {
    assert(depth.bits == BitDepth::unorm8);
    for (int level = 0; level < levels; ++level) {
        Image<char> higher(depth.grid.width, depth.grid.height);
        std::transform(depth.level.begin(), depth.level.end(), higher.begin(), [&](float code) { return code <= float(level); });
        distance_.push_back(distance_transform(higher, depth.grid, metric));
    }
}

double HeightDistances::to_higher(int i, int j, double height) const {
    const int code = int(std::ceil((1 - height) * 255 - 1e-9)) - 1; // the deepest that is higher
    return code < 0 ? infinity : distance_[std::size_t(std::min(code, levels - 1))](i, j);
}

double HeightDistances::cone(int i, int j, double lift, double ratio_max) const {
    const double apex_code = double(depth_.level(i, j)) * (1 - lift);
    double ratio = ratio_max;
    for (int level = 0; level < levels && level < apex_code; ++level)
        ratio = std::min(ratio, distance_[std::size_t(level)](i, j) / ((apex_code - level) / 255));
    return ratio;
}

} // namespace reliefbake::test

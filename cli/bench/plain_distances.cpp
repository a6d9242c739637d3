#include "cli/bench/plain_distances.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace reliefbake {

namespace {

/// Figure 2: rows to the nearest texel of 0 in the column, or `far` without one.
void scan_columns(const Image<std::uint8_t>& picture, int far, int threads, Image<std::int32_t>& rows) {
    constexpr int strip = 256; // columns a thread does at once: whole cache lines
    const int width = picture.width(), height = picture.height();
    parallel_for((width + strip - 1) / strip, threads, [&](int s) {
        const int first = s * strip, last = std::min(width, first + strip);
        for (int y = 0; y < height; ++y)
            for (int x = first; x < last; ++x)
                rows(x, y) = picture(x, y) == 0 ? 0 : y == 0 ? far : std::min(far, rows(x, y - 1) + 1);
        for (int y = height - 2; y >= 0; --y)
            for (int x = first; x < last; ++x) rows(x, y) = std::min(rows(x, y), rows(x, y + 1) + 1);
    });
}

/// Figure 3: the lower envelope of the parabolas of a row.
void scan_row(const std::int32_t* rows, int width, std::vector<int>& tops, std::vector<std::int64_t>& starts, float* out) {
    const auto value = [&](std::int64_t x, std::int64_t a) { return (x - a) * (x - a) + std::int64_t(rows[a]) * rows[a]; };
    int q = 0;
    tops[0] = 0, starts[0] = 0;
    for (int u = 1; u < width; ++u) {
        while (q >= 0 && value(starts[std::size_t(q)], tops[std::size_t(q)]) > value(starts[std::size_t(q)], u)) --q;
        if (q < 0) {
            q = 0, tops[0] = u, starts[0] = 0;
            continue;
        }
        const std::int64_t a = tops[std::size_t(q)], b = u;
        // The last column where a is at least as near as b; the numerator is not negative.
        const std::int64_t start = 1 + (b * b - a * a + std::int64_t(rows[b]) * rows[b] - std::int64_t(rows[a]) * rows[a]) / (2 * (b - a));
        if (start >= width) continue;
        ++q;
        tops[std::size_t(q)] = u, starts[std::size_t(q)] = start;
    }
    for (int x = width - 1; x >= 0; --x) {
        out[x] = float(std::sqrt(double(value(x, tops[std::size_t(q)]))));
        if (x == starts[std::size_t(q)]) --q;
    }
}

} // namespace

void plain_distances(const Image<std::uint8_t>& picture, int threads, const std::function<void(int y, const float* row)>& take_row) {
    const int width = picture.width(), height = picture.height();
    Image<std::int32_t> rows(width, height);
    scan_columns(picture, 2 * (width + height), threads, rows);
    constexpr int band = 16; // rows a thread does with one set of buffers
    parallel_for((height + band - 1) / band, threads, [&](int b) {
        std::vector<int> tops(static_cast<std::size_t>(width));
        std::vector<std::int64_t> starts(tops.size());
        std::vector<float> out(tops.size());
        for (int y = b * band; y < std::min(height, (b + 1) * band); ++y) {
            scan_row(rows.row(y), width, tops, starts, out.data());
            take_row(y, out.data());
        }
    });
}

} // namespace reliefbake

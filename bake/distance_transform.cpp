#include "bake/distance_transform.h"

#include "bake/distance_kernels.h"
#include "bake/parallel.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>
#include <type_traits>
#include <vector>

namespace reliefbake {

namespace {

/// Rows whose counts stay in a core's cache while they are worked on; few enough for PictureBand.
int rows_a_band(int width) {
    constexpr int counts_in_cache = 1 << 17;
    return std::clamp(counts_in_cache / width, 16, 64);
}

/// The picture in bands of rows, and what each column's count is where it enters a band.
struct Bands {
    const Image<std::uint8_t>& picture;
    std::uint8_t set;
    int rows, count;
    Image<RowCount> down; ///< row b: count in the row above band b
    Image<RowCount> up;   ///< row b: count in the row below band b
    std::vector<std::uint8_t> column_set; ///< whether a column holds a set texel

    int top(int band) const { return band * rows; }
    PictureBand at(int band) const {
        return {picture.row(top(band)), picture.width(), std::min(rows, picture.height() - top(band)), set};
    }
};

/// Calls work(scratch, i) for all i in [0, count), with one scratch made for each thread.
template <class Scratch, class Work>
void parallel_with_scratch(int count, int threads, const Scratch& prototype, const Work& work) {
    if (threads <= 0) threads = available_threads();
    std::atomic<int> next = 0;
    parallel_for(std::min(count, threads), threads, [&](int) {
        Scratch scratch = prototype;
        for (int i = next++; i < count; i = next++) work(scratch, i);
    });
}

RowCount farther(RowCount count, int rows) { return RowCount(std::min(int(count) + rows, int(no_row))); }

/// Turns each band's own first and last set row into the counts that enter its neighbours; `wrap` goes around once more.
void carry_counts(Bands& bands, bool wrap) {
    // down(b), up(b) hold the counts from band b's bottom, top alone.
    const std::size_t width = std::size_t(bands.picture.width());
    std::vector<RowCount> carried(width, no_row);
    const auto sweep = [&](Image<RowCount>& edges, int from, int to, int step, bool keep) {
        for (int b = from; b != to; b += step) {
            const int rows = bands.at(b).height;
            RowCount* edge = edges.row(b);
            for (std::size_t x = 0; x < width; ++x) {
                const RowCount leaving = std::min(edge[x], farther(carried[x], rows));
                if (keep) edge[x] = carried[x];
                carried[x] = leaving;
            }
        }
    };
    if (wrap) sweep(bands.down, 0, bands.count, 1, false);
    sweep(bands.down, 0, bands.count, 1, true);
    carried.assign(width, no_row);
    if (wrap) sweep(bands.up, bands.count - 1, -1, -1, false);
    sweep(bands.up, bands.count - 1, -1, -1, true);
}

Bands split(const Image<std::uint8_t>& picture, const DistanceOptions& options, const DistanceKernels& kernels) {
    const int rows = rows_a_band(picture.width()), count = (picture.height() + rows - 1) / rows;
    const std::size_t width = std::size_t(picture.width());
    Bands bands{picture, options.set, rows, count, Image<RowCount>(picture.width(), count), Image<RowCount>(picture.width(), count),
                std::vector<std::uint8_t>(width)};
    parallel_with_scratch(count, options.threads, std::vector<std::uint8_t>(2 * width), [&](std::vector<std::uint8_t>& scratch, int b) {
        kernels.band_edges(bands.at(b), scratch.data(), bands.up.row(b), bands.down.row(b));
    });
    for (int b = 0; b < count; ++b)
        for (std::size_t x = 0; x < width; ++x) bands.column_set[x] |= bands.up.row(b)[x] != no_row;
    carry_counts(bands, options.wrap_y);
    return bands;
}

/// One row's way from column distances to distances. T as in EnvelopeRow.
template <class T>
struct RowShape {
    int width, margin; ///< candidates on either side of the row, of the copies beside it
    float reach;
    std::vector<T> squares; ///< squares[d + middle()]

    int count() const { return width + 2 * margin; }
    int middle() const { return count() + envelope_padding; }
};

std::int64_t square_of(std::int64_t d, DistanceTo to) {
    if (to == DistanceTo::centres) return d * d;
    return d == 0 ? 0 : (2 * d - 1) * (2 * d - 1);
}

int margin_of(int width, bool wrap) { return wrap ? width / 2 : 0; }

/// Whether every sum of two squares that can be the smallest lies below RowSquares<uint32_t>::infinite, and no other overflows.
bool fits_32_bits(const Image<std::uint8_t>& picture, const DistanceOptions& options) {
    constexpr std::int64_t limit = RowSquares<std::uint32_t>::infinite;
    const int width = picture.width(), margin = margin_of(width, options.wrap_x);
    const int farthest_x = options.wrap_x ? margin : width - 1, farthest_y = options.wrap_y ? picture.height() / 2 : picture.height() - 1;
    return square_of(width + margin + envelope_padding, options.to) < limit &&
           square_of(farthest_x, options.to) + square_of(farthest_y, options.to) < limit;
}

template <class T>
RowShape<T> make_row_shape(int width, const DistanceOptions& options) {
    RowShape<T> shape{width, margin_of(width, options.wrap_x), options.to == DistanceTo::centres ? 1.0f : 0.5f, {}};
    shape.squares.resize(std::size_t(2 * shape.middle() + 1));
    for (int d = -shape.middle(); d <= shape.middle(); ++d) {
        // Farther than width + margin only what is infinite is looked up: any value will do that does not overflow.
        const int away = std::min(std::abs(d), width + shape.margin + envelope_padding);
        shape.squares[std::size_t(d + shape.middle())] = T(square_of(away, options.to));
    }
    return shape;
}

/// What one thread works with.
template <class T>
struct Scratch {
    std::vector<RowCount> down, count, rows; ///< a band of counts; the running count; a row
    std::vector<T> column, envelope;
};

template <class T>
class RowPass {
  public:
    RowPass(const Bands& bands, const DistanceOptions& options, const DistanceKernels& kernels, Image<float>& out)
        : bands_(bands), options_(options), kernels_(kernels), out_(out), shape_(make_row_shape<T>(out.width(), options)) {}

    void run() {
        const std::size_t width = std::size_t(out_.width());
        const Scratch<T> prototype{std::vector<RowCount>(width * std::size_t(bands_.rows)), std::vector<RowCount>(width),
                                   std::vector<RowCount>(width),
                                   std::vector<T>(std::size_t(shape_.count()) + envelope_padding, RowSquares<T>::infinite),
                                   std::vector<T>(width + envelope_padding)};
        parallel_with_scratch(bands_.count, options_.threads, prototype, [&](Scratch<T>& scratch, int b) { do_band(scratch, b); });
    }

  private:
    void do_band(Scratch<T>& s, int b) const {
        const PictureBand band = bands_.at(b);
        const std::size_t width = std::size_t(band.width);
        std::copy_n(bands_.down.row(b), width, s.count.data());
        for (int y = 0; y < band.height; ++y)
            kernels_.count_row(band.row(y), band.width, band.set, s.count.data(), s.down.data() + std::size_t(y) * width);
        std::copy_n(bands_.up.row(b), width, s.count.data());
        for (int y = band.height - 1; y >= 0; --y) {
            kernels_.merge_row(band.row(y), band.width, band.set, s.count.data(), s.down.data() + std::size_t(y) * width, s.rows.data());
            do_row(s, out_.row(bands_.top(b) + y));
        }
    }

    void do_row(Scratch<T>& s, float* out) const {
        const int width = shape_.width, margin = shape_.margin;
        const bool to_squares = options_.to == DistanceTo::squares;
        T* column = s.column.data() + margin;
        if constexpr (std::is_same_v<T, double>) kernels_.square_row64(s.rows.data(), width, to_squares, bands_.column_set.data(), column);
        else kernels_.square_row32(s.rows.data(), width, to_squares, bands_.column_set.data(), column);
        std::copy_n(column + width - margin, margin, column - margin);
        std::copy_n(column, margin, column + width);
        const EnvelopeRow<T> row{s.column.data(), shape_.count(), margin, margin + width - 1, shape_.squares.data() + shape_.middle(),
                                 shape_.reach};
        const float unit = to_squares ? 0.5f : 1.0f;
        constexpr std::size_t cached = std::size_t(4) << 20; // texels whose distances a last-level cache may keep for the next reader
        const bool stream = out_.size() > cached;
        if constexpr (std::is_same_v<T, double>) {
            kernels_.envelope64(row, s.envelope.data());
            kernels_.root_row64(s.envelope.data(), width, unit, stream, out);
        } else {
            kernels_.envelope32(row, s.envelope.data());
            kernels_.root_row32(s.envelope.data(), width, unit, stream, out);
        }
    }

    const Bands& bands_;
    const DistanceOptions& options_;
    const DistanceKernels& kernels_;
    Image<float>& out_;
    RowShape<T> shape_;
};

} // namespace

void distance_transform(const Image<std::uint8_t>& picture, const DistanceOptions& options, Image<float>& out) {
    assert(out.width() == picture.width() && out.height() == picture.height() && options.set <= 1);
    const DistanceKernels kernels = distance_kernels();
    const Bands bands = split(picture, options, kernels);
    if (std::count(bands.column_set.begin(), bands.column_set.end(), 0) == picture.width()) {
        std::fill(out.begin(), out.end(), std::numeric_limits<float>::infinity());
        return;
    }
    if (fits_32_bits(picture, options)) RowPass<std::uint32_t>(bands, options, kernels, out).run();
    else RowPass<double>(bands, options, kernels, out).run();
}

Image<float> distance_transform(const Image<std::uint8_t>& picture, const DistanceOptions& options) {
    Image<float> out(picture.width(), picture.height());
    distance_transform(picture, options, out);
    return out;
}

} // namespace reliefbake

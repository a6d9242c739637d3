#pragma once
// The inner loops of the distance transform, in SIMD. All results are whole numbers, or correctly rounded: the same for every width.

#include <cstddef>
#include <cstdint>

namespace reliefbake {

/// A count of rows, or that there is nothing to count to.
using RowCount = std::uint16_t;
constexpr RowCount no_row = 0xffff;

/// Some rows of a picture of 0 and 1; `set` is the value that distances are measured to.
struct PictureBand {
    const std::uint8_t* rows;
    int width, height; ///< at most 254 rows
    std::uint8_t set;

    const std::uint8_t* row(int y) const { return rows + std::size_t(y) * std::size_t(width); }
};

/// One row's squared column distances, beyond whose ends there is nothing, and what is wanted of them. T: uint32_t, or double where
/// squares exceed 32 bits; both exact.
template <class T>
struct EnvelopeRow {
    const T* column;   ///< of each candidate; `count` of them and `envelope_padding` more, all of those RowSquares<T>::infinite
    int count;
    int first, last;   ///< columns wanted
    const T* squares;  ///< squares[d]: square of the distance d along the row, |d| < count + envelope_padding
    float reach;       ///< no candidate farther than sqrt(value) * reach + 2 has a square below value
};

constexpr int envelope_padding = 64;

template <class T>
struct RowSquares;
template <>
struct RowSquares<std::uint32_t> {
    static constexpr std::uint32_t infinite = 0x80000000u; ///< all squares, and sums of two that matter, lie below
};
template <>
struct RowSquares<double> {
    static constexpr double infinite = 0x1p60;
};

struct DistanceKernels {
    /// For each column: rows from the band's top (bottom) to the first (last) set texel; no_row without one.
    void (*band_edges)(const PictureBand& band, std::uint8_t* scratch, RowCount* from_top, RowCount* from_bottom);
    /// Steps a row on: count = 0 where it is set, else count + 1, which stays at no_row; out = the same.
    void (*count_row)(const std::uint8_t* row, int width, std::uint8_t set, RowCount* count, RowCount* out);
    /// The same upwards, then out = the smaller of the count and `down`.
    void (*merge_row)(const std::uint8_t* row, int width, std::uint8_t set, RowCount* count, const RowCount* down, RowCount* out);
    /// out = squared distances: d^2, or (2 d - 1)^2 for squares of texels (0 for d = 0); infinite where `column_set` is 0.
    void (*square_row32)(const RowCount* rows, int width, bool to_squares, const std::uint8_t* column_set, std::uint32_t* out);
    void (*square_row64)(const RowCount* rows, int width, bool to_squares, const std::uint8_t* column_set, double* out);
    /// out[x - first] = smallest column[a] + squares[x - a]. Writes up to envelope_padding more.
    void (*envelope32)(const EnvelopeRow<std::uint32_t>& row, std::uint32_t* out);
    void (*envelope64)(const EnvelopeRow<double>& row, double* out);
    /// out = unit * sqrt(square), correctly rounded; unit a power of 2. `stream`: past the caches.
    void (*root_row32)(const std::uint32_t* squares, int width, float unit, bool stream, float* out);
    void (*root_row64)(const double* squares, int width, float unit, bool stream, float* out);
};

/// For the instruction set in use (bake/simd.h).
DistanceKernels distance_kernels();

} // namespace reliefbake

#include "bake/distance_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bake/distance_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reliefbake {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Calls body(tag, x) for vectors of T from 0 on, and one by one for what is left.
template <class T, class Body>
HWY_INLINE void ForVectors(int count, const Body& body) {
    const hn::ScalableTag<T> d;
    const int lanes = int(hn::Lanes(d));
    int x = 0;
    for (; x + lanes <= count; x += lanes) body(d, x);
    for (; x < count; ++x) body(hn::CappedTag<T, 1>(), x);
}

void BandEdges(const PictureBand& band, std::uint8_t* scratch, RowCount* from_top, RowCount* from_bottom) {
    // Bytes suffice inside a band: first set row, and one past the last.
    std::uint8_t *first = scratch, *end = scratch + band.width;
    std::memset(first, 0xff, std::size_t(band.width));
    std::memset(end, 0, std::size_t(band.width));
    for (int y = 0; y < band.height; ++y) {
        const std::uint8_t* row = band.row(y);
        ForVectors<std::uint8_t>(band.width, [&](auto d, int x) {
            const auto unset = hn::Sub(hn::Zero(d), hn::Xor(hn::LoadU(d, row + x), hn::Set(d, band.set))); // 0 or 255
            const auto here = hn::Set(d, std::uint8_t(y)), past = hn::Set(d, std::uint8_t(y + 1));
            hn::StoreU(hn::Min(hn::LoadU(d, first + x), hn::Or(here, unset)), d, first + x);
            hn::StoreU(hn::Max(hn::LoadU(d, end + x), hn::AndNot(unset, past)), d, end + x);
        });
    }
    for (int x = 0; x < band.width; ++x) {
        from_top[x] = first[x] == 0xff ? no_row : first[x];
        from_bottom[x] = end[x] == 0 ? no_row : RowCount(band.height - end[x]);
    }
}

/// count + 1 where the row is not set, else 0.
template <class D>
HWY_INLINE hn::Vec<D> Counted(D d, const std::uint8_t* row, std::uint8_t set, const RowCount* count) {
    const hn::Rebind<std::uint8_t, D> bytes;
    const auto texel = hn::PromoteTo(d, hn::LoadU(bytes, row));
    const auto unset = hn::Sub(hn::Zero(d), hn::Xor(texel, hn::Set(d, RowCount(set))));
    return hn::And(hn::SaturatedAdd(hn::LoadU(d, count), hn::Set(d, RowCount(1))), unset);
}

void CountRow(const std::uint8_t* row, int width, std::uint8_t set, RowCount* count, RowCount* out) {
    ForVectors<RowCount>(width, [&](auto d, int x) {
        const auto counted = Counted(d, row + x, set, count + x);
        hn::StoreU(counted, d, count + x);
        hn::StoreU(counted, d, out + x);
    });
}

void MergeRow(const std::uint8_t* row, int width, std::uint8_t set, RowCount* count, const RowCount* down, RowCount* out) {
    ForVectors<RowCount>(width, [&](auto d, int x) {
        const auto counted = Counted(d, row + x, set, count + x);
        hn::StoreU(counted, d, count + x);
        hn::StoreU(hn::Min(counted, hn::LoadU(d, down + x)), d, out + x);
    });
}

void SquareRow32(const RowCount* rows, int width, bool to_squares, const std::uint8_t* column_set, std::uint32_t* out) {
    ForVectors<std::uint32_t>(width, [&](auto d, int x) {
        const hn::Rebind<RowCount, decltype(d)> counts;
        const hn::Rebind<std::uint8_t, decltype(d)> bytes;
        auto along = hn::PromoteTo(d, hn::LoadU(counts, rows + x));
        if (to_squares) { // 2 d - 1, and 0 for 0
            const auto twice = hn::Add(along, along);
            along = hn::Sub(hn::Max(twice, hn::Set(d, 1u)), hn::Set(d, 1u));
        }
        const auto empty = hn::Eq(hn::PromoteTo(d, hn::LoadU(bytes, column_set + x)), hn::Zero(d));
        hn::StoreU(hn::IfThenElse(empty, hn::Set(d, RowSquares<std::uint32_t>::infinite), hn::Mul(along, along)), d, out + x);
    });
}

void SquareRow64(const RowCount* rows, int width, bool to_squares, const std::uint8_t* column_set, double* out) {
    for (int x = 0; x < width; ++x) {
        const double along = to_squares ? std::max(2.0 * rows[x], 1.0) - 1 : rows[x];
        out[x] = column_set[x] ? along * along : RowSquares<double>::infinite;
    }
}

/// The lower envelope of a row: out[x] = min over a of column[a] + squares[x - a].
/// The squares are convex, so that two candidates' curves cross once: the best candidate of a column never lies left of that of a
/// column further left. So the best of every 2^k-th column, then of those half-way between them, and so on, are each sought between two
/// that are known: one halving looks at no more than all candidates and one more for each column. What is left between two known
/// columns is tried in vectors.
template <class T>
class Envelope {
  public:
    Envelope(const EnvelopeRow<T>& row, T* out) : row_(row), out_(out) {}

    void Solve() {
        const int blocks = (row_.last - row_.first) / kBlock + 1; // the last one ends with the row, within its columns
        const auto column = [&](int k) { return std::min(row_.first + k * kBlock, row_.last); };
        int best[kMostBlocks + 1]; // of the columns between blocks
        best[0] = Best(column(0), 0, row_.count - 1);
        best[blocks] = Best(column(blocks), 0, row_.count - 1);
        int step = 1;
        while (2 * step < blocks) step *= 2;
        for (; step > 0; step /= 2) // those of one step do not wait for each other
            for (int k = step; k < blocks; k += 2 * step) {
                const int from = best[k - step], to = best[std::min(k + step, blocks)];
                best[k] = from >= to ? from : Best(column(k), from, to);
            }
        for (int k = 0; k < blocks; ++k) Fill(column(k), column(k + 1), best[k], best[k + 1]);
    }

  private:
    using D = hn::ScalableTag<T>;
    static constexpr int kBlock = 32; ///< columns between two whose best candidate is sought
    static constexpr int kMostBlocks = 65536 / kBlock + 1;
    static constexpr int kFew = 256;  ///< candidates that need no narrowing
    static constexpr int kLanes = HWY_LANES(T) < kBlock ? int(HWY_LANES(T)) : kBlock;
    static constexpr int kVectors = kBlock / kLanes;

    T Value(int x, int a) const { return row_.column[a] + row_.squares[x - a]; }

    /// The best candidate in [from, to] for column x; one of them is the best of all. What lies beyond `to` are other candidates, or
    /// infinite ones: looking at them is harmless.
    int Best(int x, int from, int to) const {
        if (row_.column[x] == 0) return x;
        if (to - from >= kFew) Narrow(x, from, to);
        const D d;
        const int lanes = int(hn::Lanes(d));
        const T *column = row_.column + from, *squares = row_.squares + (from - x);
        const auto value = [&](int k) { return hn::Add(hn::LoadU(d, column + k), hn::LoadU(d, squares + k)); };
        const int count = to - from + 1;
        auto best = value(0);
        for (int k = lanes; k < count; k += lanes) best = hn::Min(best, value(k));
        best = hn::MinOfLanes(d, best);
        for (int k = 0;; k += lanes) {
            const auto at = hn::FindFirstTrue(d, hn::Eq(value(k), best));
            if (at >= 0) return from + k + int(at);
        }
    }

    /// A candidate farther away than the root of a value cannot undercut it.
    void Narrow(int x, int& from, int& to) const {
        const T bound = std::min(row_.column[x], std::min(Value(x, from), Value(x, to)));
        const int reach = int(std::min(float(row_.count), row_.reach * std::sqrt(float(bound)) + 2));
        from = std::max(from, x - reach), to = std::min(to, x + reach);
    }

    /// Columns left to right with candidates from..to. What is written beyond the right end is written again by the next block.
    void Fill(int left, int right, int from, int to) {
        const hn::CappedTag<T, kBlock> d;
        const int lanes = int(hn::Lanes(d));
        T* out = out_ + (left - row_.first);
        if (IsInside(left, right)) {
            std::fill_n(out, right - left + 1, T(0));
            return;
        }
        hn::Vec<decltype(d)> best[kVectors];
        const T* squares = row_.squares + (left - from);
        const auto first = hn::Set(d, row_.column[from]);
        for (int k = 0; k < kVectors; ++k) best[k] = hn::Add(first, hn::LoadU(d, squares + k * lanes));
        for (int a = from + 1; a <= to; ++a) {
            const auto height = hn::Set(d, row_.column[a]);
            --squares;
            for (int k = 0; k < kVectors; ++k) best[k] = hn::Min(best[k], hn::Add(height, hn::LoadU(d, squares + k * lanes)));
        }
        for (int k = 0; k < kVectors; ++k) hn::StoreU(best[k], d, out + k * lanes);
    }

    bool IsInside(int left, int right) const {
        if (row_.column[left] != 0 || row_.column[right] != 0) return false;
        const T* column = row_.column + left;
        T all = 0;
        for (int k = 0; k < right - left; ++k) all = std::max(all, column[k]);
        return all == 0;
    }

    const EnvelopeRow<T>& row_;
    T* out_;
};

void Envelope32(const EnvelopeRow<std::uint32_t>& row, std::uint32_t* out) { Envelope<std::uint32_t>(row, out).Solve(); }
void Envelope64(const EnvelopeRow<double>& row, double* out) { Envelope<double>(row, out).Solve(); }

/// Squares below 2^24 are floats; the root of larger ones is taken in double. Its second rounding, to float, is the right one: a
/// whole number's root is no closer than 2^-51 of itself to the middle between two floats unless it lies on it.
template <class D>
HWY_INLINE hn::Vec<D> Roots(D d, const std::uint32_t* squares, float unit) {
    const hn::RebindToSigned<D> di;
    const auto whole = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(squares));
    const auto large = hn::Gt(whole, hn::Set(di, (1 << 24) - 1));
    auto root = hn::Sqrt(hn::ConvertTo(d, whole));
    if (HWY_UNLIKELY(!hn::AllFalse(di, large))) {
        HWY_ALIGN float roots[HWY_LANES(float)];
        for (std::size_t k = 0; k < hn::Lanes(d); ++k) roots[k] = float(std::sqrt(double(squares[k])));
        root = hn::Load(d, roots);
    }
    return hn::Mul(root, hn::Set(d, unit));
}

void RootRow32(const std::uint32_t* squares, int width, float unit, bool stream, float* out) {
    const hn::ScalableTag<float> d;
    const bool aligned = stream && reinterpret_cast<std::uintptr_t>(out) % (hn::Lanes(d) * sizeof(float)) == 0;
    ForVectors<float>(width, [&](auto tag, int x) {
        const auto root = Roots(tag, squares + x, unit);
        if (aligned && hn::MaxLanes(tag) > 1) hn::Stream(root, tag, out + x);
        else hn::StoreU(root, tag, out + x);
    });
}

void RootRow64(const double* squares, int width, float unit, bool, float* out) {
    for (int x = 0; x < width; ++x) out[x] = float(std::sqrt(squares[x])) * unit;
}

} // namespace HWY_NAMESPACE
} // namespace reliefbake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reliefbake {
HWY_EXPORT(BandEdges);
HWY_EXPORT(CountRow);
HWY_EXPORT(MergeRow);
HWY_EXPORT(SquareRow32);
HWY_EXPORT(SquareRow64);
HWY_EXPORT(Envelope32);
HWY_EXPORT(Envelope64);
HWY_EXPORT(RootRow32);
HWY_EXPORT(RootRow64);

DistanceKernels distance_kernels() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets()); // so that the addresses are final
    return {&HWY_DYNAMIC_DISPATCH(BandEdges),   &HWY_DYNAMIC_DISPATCH(CountRow),    &HWY_DYNAMIC_DISPATCH(MergeRow),
            &HWY_DYNAMIC_DISPATCH(SquareRow32), &HWY_DYNAMIC_DISPATCH(SquareRow64), &HWY_DYNAMIC_DISPATCH(Envelope32),
            &HWY_DYNAMIC_DISPATCH(Envelope64),  &HWY_DYNAMIC_DISPATCH(RootRow32),   &HWY_DYNAMIC_DISPATCH(RootRow64)};
}

} // namespace reliefbake
#endif // HWY_ONCE

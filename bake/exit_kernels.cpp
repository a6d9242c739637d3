#include "bake/exit_kernels.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bake/exit_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reliefbake {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// body(d, x) for whole vectors, then for the single floats that remain.
template <class Body>
HWY_INLINE void ForRow(std::ptrdiff_t count, const Body& body) {
    const HWY_CAPPED(float, 8) d;
    const std::ptrdiff_t lanes = std::ptrdiff_t(hn::Lanes(d));
    std::ptrdiff_t x = 0;
    for (; x + lanes <= count; x += lanes) body(d, x);
    for (; x < count; ++x) body(HWY_CAPPED(float, 1)(), x);
}

void FallingCells(const float* row0, const float* row1, float inverse_pitch, float least_sq, std::ptrdiff_t count, float* out) {
    ForRow(count, [=](auto d, std::ptrdiff_t x) HWY_ATTR {
        // Steepest fall along x and y: every point of the cell falls between its edges.
        const auto h00 = hn::LoadU(d, row0 + x), h10 = hn::LoadU(d, row0 + x + 1);
        const auto h01 = hn::LoadU(d, row1 + x), h11 = hn::LoadU(d, row1 + x + 1);
        const auto zero = hn::Zero(d);
        const auto a = hn::Max(hn::Max(hn::Sub(h00, h10), hn::Sub(h01, h11)), zero);
        const auto b = hn::Mul(hn::Max(hn::Max(hn::Sub(h00, h01), hn::Sub(h10, h11)), zero), hn::Set(d, inverse_pitch));
        const auto fall_sq = hn::Add(hn::Mul(a, a), hn::Mul(b, b));
        const auto falls = hn::Gt(hn::Mul(fall_sq, hn::Set(d, 1 + 0x1p-20f)), hn::Set(d, least_sq));
        hn::StoreU(hn::IfThenElse(falls, zero, hn::Set(d, std::numeric_limits<float>::infinity())), d, out + x);
    });
}

void MaskPoints(const CellPoints& points, std::ptrdiff_t count, float* height, float* from) {
    ForRow(count, [=](auto d, std::ptrdiff_t x) HWY_ATTR {
        const float* here = points.falls + x;
        const float* above = here - points.back_y;
        const auto least = hn::Min(hn::Min(hn::LoadU(d, here), hn::LoadU(d, here - points.back_x)),
                                   hn::Min(hn::LoadU(d, above), hn::LoadU(d, above - points.back_x)));
        const auto counts = hn::Lt(least, hn::Set(d, std::numeric_limits<float>::infinity()));
        hn::StoreU(hn::IfThenElse(counts, hn::LoadU(d, points.height + x), hn::Set(d, points.lowest)), d, height + x);
        if (from) hn::StoreU(least, d, from + x);
    });
}

} // namespace HWY_NAMESPACE
} // namespace reliefbake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reliefbake {
HWY_EXPORT(FallingCells);
HWY_EXPORT(MaskPoints);

ExitKernels exit_kernels() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets()); // so that the addresses are final
    return {&HWY_DYNAMIC_DISPATCH(FallingCells), &HWY_DYNAMIC_DISPATCH(MaskPoints)};
}

} // namespace reliefbake
#endif // HWY_ONCE

#pragma once
// The inner loops of exits.cpp and of masked blocks, in SIMD lanes along a row.

#include <cstddef>

namespace reliefbake {

/// Points that touch cells: the cell at the same place, and those `back_x` before it and `back_y` rows up (0: the same again).
struct CellPoints {
    const float* falls; ///< distance from which each cell counts; infinity: never
    const float* height;
    std::ptrdiff_t back_x, back_y;
    float lowest; ///< height of points that touch no cell that counts
};

/// The kernels for the widest instruction set in use (bake/simd.h). Same bits for all of them.
struct ExitKernels {
    /// out[x] = 0 where the cell between two rows falls right or down by a square above `least_sq`, else infinity.
    void (*falling_cells)(const float* row0, const float* row1, float inverse_pitch, float least_sq, std::ptrdiff_t count, float* out);
    /// Heights of the points, those that touch no cell that counts at `lowest`; `from`, unless null: the cells' least distance.
    void (*mask_points)(const CellPoints& points, std::ptrdiff_t count, float* height, float* from);
};

ExitKernels exit_kernels();

} // namespace reliefbake

#pragma once
// The inner loops of the near half of the bake, in SIMD lanes along a row.

#include "bake/search_surface.h"

#include <cstddef>
#include <vector>

namespace reliefbake {

/// Neighbours at one distance: slope = (highest of them - own height) * inverse_distance.
struct Ring {
    float inverse_distance;
    float reach;            ///< farthest that points of the two cells can be apart, texels
    std::size_t begin, end; ///< range of Rings::offsets
};
struct Rings {
    std::vector<Ring> rings;
    std::vector<std::ptrdiff_t> offsets; ///< of a neighbour, in floats
};

/// One row of lattice points and what surrounds them. `own` and `other` are parallel planes.
struct RingRows {
    const float* own;   ///< heights of the cones' apexes
    const float* other; ///< heights that a cone must not hold
    const float* from;  ///< distance from which a neighbour counts; null: always
    float least;        ///< slope to start from
    float slack;        ///< covers the rounding of heights
};

/// Slopes of the bilinear surface within one texel, squared, for a wedge.
struct WedgeCells {
    const float* const* rows; ///< four rows of heights; rows[1] and rows[2] hold the corners of the cells
    const float* const* fall; ///< rows 1 and 2 of cells: below infinity where a cell counts; null: all do
    float aspect, t0, t1;
};

/// The largest of the slopes over the footprints of a row of texels.
struct FootprintRows {
    const float* texels;     ///< at the row's first texel; all planes have the same stride
    const float* lattice[4]; ///< phase (sx, sy) of the half-texel lattice at sx + 2 sy; null: not used
    const float* cells;      ///< squared; null: not used
    std::ptrdiff_t stride;
    Footprint footprint;
};

/// The kernels for the widest instruction set in use (bake/simd.h). Same bits for all of them. Each fills out[0, count),
/// and may write a few floats more.
struct NearKernels {
    void (*ring_slopes)(const RingRows&, const Rings&, int count, float* out);
    void (*cell_slopes)(const float* const* rows, float aspect, int count, float* out); ///< all directions, squared
    void (*wedge_cell_slopes)(const WedgeCells&, int count, float* out);                ///< squared
    void (*footprint_slopes)(const FootprintRows&, int first, int count, float* out);   ///< of texels first, first + 1, ...
};

NearKernels near_kernels();

} // namespace reliefbake

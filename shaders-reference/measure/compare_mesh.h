#pragma once
// Curved relief judged by the mesh really displaced (MATHS section 9), pixel by pixel.

#include "bake/image.h"

#include <cstdint>
#include <span>

namespace reliefbake {

/// One view, thrice: distances from the eye along the line of sight, one a pixel, +inf where there is nothing.
struct MeshPlanes {
    Image<float> base;      ///< the mesh as it is: where a shader is asked at all
    Image<float> truth;     ///< displaced
    Image<float> rendering; ///< by the shader; NaN where a result is not finite
    Image<float> steps;     ///< of the march; counted where the base is
};

struct MeshComparison {
    std::uint64_t base = 0, truth = 0, rendering = 0; ///< pixels covered
    std::uint64_t both = 0;        ///< by truth and rendering
    std::uint64_t holes = 0;       ///< the truth covers, the rendering does not
    std::uint64_t wrong_cover = 0; ///< the rendering covers, the truth does not
    std::uint64_t not_finite = 0;  ///< pixels that are NaN; not covered
    std::uint64_t band = 0;        ///< silhouette band: base and truth differ in cover
    std::uint64_t band_right = 0;  ///< pixels of the band where the rendering covers as the truth does
    std::uint64_t cut = 0;         ///< pixels of the base that truth or rendering leave bare
    std::uint64_t cut_both = 0;    ///< that both leave bare
    /// |distance| between truth and rendering where both cover, in the unit given: mean, exceeded by one pixel in a hundred, most.
    double depth_mean = 0, depth_99 = 0, depth_max = 0;
    double steps_mean = 0, steps_max = 0; ///< over pixels of the base

    double iou() const { return share(both, both + holes + wrong_cover); } ///< of covers
    /// Share of the band that is right; 0 for a shader that never discards. Holes elsewhere do not count.
    double band_agreement() const { return share(band_right, band); }
    /// Intersection over union of what is cut away from the base; 0 for a shader that never discards. Holes count.
    double cut_iou() const { return share(cut_both, cut); }

  private:
    static double share(std::uint64_t part, std::uint64_t whole) { return whole > 0 ? double(part) / double(whole) : 1; }
};

/// All views together. `unit`: length that depth errors are divided by, > 0. All images of a view have one size.
MeshComparison compare_mesh(std::span<const MeshPlanes> views, double unit);

} // namespace reliefbake

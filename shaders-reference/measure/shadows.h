#pragma once
// Shadows of a rendering judged by exact rays to the sun (MATHS section 9's oracle).

#include "shaders-reference/oracle/bilinear_surface.h"
#include "shaders-reference/renderer/rendering.h"
#include "shaders-reference/renderer/scene.h"

#include <cstdint>

namespace reliefbake {

struct ShadowComparison {
    std::uint64_t pixels = 0;  ///< that show relief
    std::uint64_t dark = 0;    ///< of them in the exact shadow
    std::uint64_t leaks = 0;   ///< lit where the exact shadow lies
    std::uint64_t extra = 0;   ///< dark where the sun is seen

    double disagreement() const { return pixels > 0 ? double(leaks + extra) / double(pixels) : 0; }
};

ShadowComparison operator+(const ShadowComparison& a, const ShadowComparison& b);

/// For each pixel: whether a ray from the surface at the hit's u, v, a millionth of the depth above it, reaches the sun in double
/// precision; a pixel counts as lit when more than half of the sun is seen. `sun`: unit vector towards it. `depth_scale`: of the
/// drawing, texture widths. `threads`: 0: all; the result does not depend on it.
ShadowComparison compare_shadows(const BilinearSurface& surface, const Rendering& rendering, const Vec3& sun, double depth_scale,
                                 int threads = 0);

} // namespace reliefbake

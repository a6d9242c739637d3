#pragma once
// Tangent-space normals of the stored surface.

#include "bake/depth_slopes.h"
#include "bake/height_field.h"
#include "bake/image.h"

namespace reliefbake {

/// Unit normals; x along +u; y along *up the image* (OpenGL convention, "gl"); z = sqrt(1 - x^2 - y^2) > 0.
struct NormalMap {
    TexelGrid grid;
    Image<float> x;
    Image<float> y;
};

/// Differences of the stored depth, wrap-aware. `depth_scale`, S: depth of the relief in texture widths; it fixes
/// the slope (physical: depth / size). `threads`: 0: all the process may use; same bits for every number of them.
///
///     n = (-S dH/du, S dH/dv / R, 1) / length,   H the height, v down the image, R = grid.aspect()
NormalMap bake_normals(const DepthMap& depth, double depth_scale, int threads = 0,
                       DerivativeKernel kernel = DerivativeKernel::central);

} // namespace reliefbake

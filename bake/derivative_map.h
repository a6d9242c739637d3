#pragma once
// The depth map of revolution-bump mapping (003, figure 5): partial derivatives of the height, for bump mapping.

#include "bake/depth_slopes.h"
#include "bake/image.h"

namespace reliefbake {

/// dH/du and dH/dv of heights 0..1 at the texel centres, u and v in 0..1 across the map, v *down* the image.
///
/// With unit tangent T along +u, B along +v, N, and a relief `a` texture widths deep (003, (4) and (5); R = grid.aspect()):
///
///     N' = normalize(N + a (dH/du (N x B) - dH/dv / R (N x T))),   in the tangent frame (-a dH/du, -a dH/dv / R, 1)
struct DerivativeMap {
    TexelGrid grid;
    Image<float> du, dv;
};

/// Differences of the stored depth, wrap-aware, each rounded once to float. |dH/du| <= grid.width, |dH/dv| <= grid.height.
/// `threads`: 0: all the process may use; same bits for every number of them.
DerivativeMap bake_derivatives(const DepthMap& depth, DerivativeKernel kernel, int threads = 0);

} // namespace reliefbake

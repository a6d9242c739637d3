#include "cli/cone/bake_planes.h"

#include "bake/mips.h"

namespace reliefbake {

std::vector<ConeMap> bake_planes(const ConePlan& plan, const DepthMap& depth, ConeStatistics* statistics, SharedPyramids* shared) {
    const int planes = plan.given.planes;
    if (plan.given.adaptive) return bake_sector_cones_adaptive(depth, *plan.given.adaptive, plan.cone);
    if (plan.given.kind == "cone") return {bake_level_cones(depth, plan.cone, statistics, shared)};
    // Small levels may have texels of a shape for which no angle is searched. One cone serves every sector, stands above its own apex
    // as well, and is a line of pieces.
    if (!is_baked_pixel_aspect(depth.grid.pixel_aspect))
        return std::vector<ConeMap>(std::size_t(planes), bake_level_cones(depth, plan.cone, statistics, shared));
    if (plan.given.kind == "acm") return bake_sector_cones(depth, planes, plan.cone, statistics, shared);
    if (plan.given.kind == "cone-stack") return bake_stacked_cones(depth, planes, plan.cone, statistics, shared);
    return bake_piecewise_cones(depth, planes, plan.cone, statistics);
}

} // namespace reliefbake

#include "shaders-reference/measure/shadows.h"

#include "bake/parallel.h"
#include "shaders-reference/oracle/first_hit.h"

namespace reliefbake {
namespace {

constexpr double start_above = 1e-6; ///< of the depth: keeps the ray off the point it starts from

/// Image up is world y; a rise of one unit of height is depth_scale widths.
bool is_dark(const BilinearSurface& surface, const Quad& hit, const Vec3& sun, double depth_scale) {
    const double u = hit[0], v = hit[1], rise = sun[2] / depth_scale;
    const ReliefRay ray{u, v, surface.height(u, v) + start_above, sun[0], -sun[1] / surface.grid().aspect(), rise};
    return first_hit(surface, ray).has_value();
}

} // namespace

ShadowComparison operator+(const ShadowComparison& a, const ShadowComparison& b) {
    return {a.pixels + b.pixels, a.dark + b.dark, a.leaks + b.leaks, a.extra + b.extra};
}

ShadowComparison compare_shadows(const BilinearSurface& surface, const Rendering& rendering, const Vec3& sun, double depth_scale, int threads) {
    std::vector<ShadowComparison> rows(std::size_t(rendering.height()));
    parallel_for(rendering.height(), threads, [&](int row) {
        ShadowComparison& sum = rows[std::size_t(row)];
        for (int column = 0; column < rendering.width(); ++column) {
            const std::size_t pixel = std::size_t(row) * std::size_t(rendering.width()) + std::size_t(column);
            if (rendering.status(pixel) == RayStatus::no_ray || rendering.status(pixel) == RayStatus::hole) continue;
            const bool dark = is_dark(surface, rendering.hit[pixel], sun, depth_scale), lit = rendering.light[pixel][0] > 0.5f;
            ++sum.pixels;
            sum.dark += dark;
            sum.leaks += dark && lit;
            sum.extra += !dark && !lit;
        }
    });
    ShadowComparison total;
    for (const ShadowComparison& row : rows) total = total + row;
    return total;
}

} // namespace reliefbake

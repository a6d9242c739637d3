#pragma once
// A rendered solid judged by the oracle, ray by ray (MATHS sections 6 and 9), and a shape map's distances, point by point.

#include "bake/shape_map.h"
#include "shaders-reference/oracle/shape_solid.h"
#include "shaders-reference/renderer/shape_renderer.h"

#include <span>

namespace reliefbake {

/// The shape that a map stores, as its model says.
PixelShape stored_shape(const ShapeMap& map);

/// How far before the solid a hit may lie, texture widths: what the filter, guarantee S, the codes, the sampler and the march's epsilon
/// cost. A filtered distance may be sqrt(1/2) texel too small, and as much again is taken off by guarantee S.
double allowed_gap(const ShapeMap& map, SamplerFilter filter, double epsilon_texels);

struct SolidCompareOptions {
    double allowed_gap = 0; ///< texture widths; see above
    int threads = 0;        ///< 0: all; the result does not depend on it
};

struct SolidComparison {
    std::uint64_t rays = 0;         ///< that enter the domain
    std::uint64_t hits = 0;         ///< on the solid
    std::uint64_t missed = 0;       ///< the ray was in the solid, made smaller by the rounding of a float32 position, before it ended
    std::uint64_t early = 0;        ///< the hit lies farther from the solid than allowed
    std::uint64_t out_of_steps = 0; ///< marches that never arrived
    std::uint64_t not_finite = 0;   ///< samples with a NaN or infinity in any plane
    // Of hits on walls; those on faces of the domain, where rays enter, are left out.
    double gap_mean = 0, gap_max = 0; ///< the exact gap there, texture widths
    double normal_mean = 0;         ///< degrees between the shader's normal and the exact one there
    double normal_95 = 0;           ///< the same, exceeded by one hit in twenty
    double steps_mean = 0, steps_max = 0, fetches_mean = 0;
};

/// Follows each pixel's ray, as the shader recorded it, in all views of one solid.
SolidComparison compare_solid(const PixelShape& shape, const ShapeSolid& solid, std::span<const ShapeRendering> views, const SolidCompareOptions& options);

/// The oracle's own hits for the rays of a rendering, as CircleScheme::given takes them.
Image<Quad> oracle_solid_hits(const PixelShape& shape, const ShapeSolid& solid, const ShapeRendering& rendering, int threads = 0);

struct DistanceCheck {
    std::uint64_t points = 0;
    std::uint64_t violations = 0; ///< points from which guarantee S would let a ray enter the shape
    double worst = 0;             ///< greatest excess of the safe distance over the exact one, texels; > 0: violated
    double u = 0, v = 0;          ///< where
};

/// Guarantee S at texel centres, edges, corners, points beside the shape's outline, and random points. Deterministic in its seed, for every thread count.
DistanceCheck check_distances(const ShapeMap& map, const PixelShape& shape, int points, std::uint64_t seed, int threads = 0);

} // namespace reliefbake

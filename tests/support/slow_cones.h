#pragma once
// Slow truth: cones straight from the definitions of MATHS section 2, for fields of a few hundred texels.

#include "bake/cone.h"
#include "bake/relief_map.h"

namespace reliefbake::test {

/// Exact cone of each texel against all other texel centres, capped.
Image<float> texel_cones(const DepthMap& depth, Metric metric, double ratio_max);

/// Smallest value of each texel and its eight neighbours.
Image<float> minimum_3x3(const Image<float>& values, const TexelGrid& grid);

/// Footprint-exact L2 cone of each texel: the least cone of the bilinear surface over the four cells around the texel
/// centre, from `steps` points per texel and axis and `headings` directions each, and every gradient. A little too wide where the sampling overlooks something.
Image<float> footprint_cones(const DepthMap& depth, double ratio_max, int steps, int headings);

/// Conservative L2 cones by proof: the L1 theorem's, divided by sqrt(2). Up to 30 % narrower than need be.
Image<float> proven_l2_cones(const DepthMap& depth, double ratio_max);

enum class Rounding { down, up };

struct MapChoices {
    ConeEncoding encoding = ConeEncoding::ratio;
    BitDepth bits = BitDepth::unorm16;
    Metric metric = Metric::l2;
    Rounding rounding = Rounding::down;
};

/// Encodes cones and the stored depth, with normals by central differences (gl).
ReliefMap make_relief_map(const DepthMap& depth, const Image<float>& ratio, double ratio_max, const MapChoices& choices,
                          double depth_scale = 0.1);

} // namespace reliefbake::test

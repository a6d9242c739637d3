#pragma once
// Horizon maps (Max 1988; Sloan and Cohen 2000): how high the relief stands before the sky in eight directions, for shadows.

#include "bake/height_field.h"
#include "bake/image.h"

#include <array>
#include <utility>
#include <vector>

namespace reliefbake {

constexpr int horizon_azimuths = 8;

/// Texels that azimuth k walks by: towards the eight neighbours, from +u towards +v (v down the image). Lines through texel
/// centres along them meet texel centres alone.
constexpr std::array<std::pair<int, int>, horizon_azimuths> horizon_steps = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// Angle of azimuth k in the isotropic metric (du, R dv), radians from +u towards +v, 0 to below 2 pi: multiples of 45
/// degrees where texels are square, else diagonals at atan(pixel_aspect).
double horizon_angle(const TexelGrid& grid, int k);

/// Sine of the horizon's elevation at each texel centre, for a relief `depth_scale` S texture widths deep:
///
///     m_k(p) = sup over s > 0 of (H(p + s e_k) - H(p)) / s, at least 0;   sine_k = S m_k / sqrt(1 + S^2 m_k^2)
///
/// H is the bilinear surface of the stored depth, e_k the unit vector of azimuth k, s in texture widths. A sun whose elevation
/// has a larger sine is seen, up to the ends of the map as it is addressed: for ever where it repeats.
struct HorizonMap {
    TexelGrid grid;
    double depth_scale = 0;
    std::vector<Image<float>> sine; ///< horizon_azimuths planes, in [0, 1)
};

/// Exact for all distances: each line of the map is swept once (bake/line_horizons.h), a few roundings of double and one to
/// float. Same bits for every number of threads (0: all the process may use).
HorizonMap bake_horizons(const DepthMap& depth, double depth_scale, int threads = 0);

/// Largest error of a stored sine: half a code, and the float it was rounded from.
double horizon_error(BitDepth bits);

} // namespace reliefbake

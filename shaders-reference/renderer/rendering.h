#pragma once
// What one frame yields: a picture, and for every sample of it the ray and what became of it.

#include "bake/image.h"

#include <array>
#include <cstdint>
#include <vector>

namespace reliefbake {

/// 8-bit sRGB, row-major, the top row first.
struct RgbImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

enum class RayStatus {
    no_ray = 0,       ///< the pixel shows no relief
    hit = 1,
    out_of_steps = 2, ///< the march stopped above the relief
    passed = 3,       ///< solids: left the domain without a hit
    hole = 4,         ///< the ray came down to the floor where there is none: the pixel shows what is behind
};

using Quad = std::array<float, 4>;

/// Planes of float32, the top row first; size: picture times supersampling. Nothing is rounded on the way from the
/// shader, so an oracle fed with `ray` follows the very ray that the shader followed.
struct Rendering {
    Image<Quad> hit;    ///< u, v (unwrapped, seen from the ray's own tile), h, gap above the sampled relief
    Image<Quad> counts; ///< steps, fetches, RayStatus, t (descent)
    Image<Quad> ray;    ///< origin u, v at height 1; du, dv per unit of descent
    Image<Quad> light;  ///< share of the sun seen, 0 where the relief faces away from it; three times nothing
    Image<float> depth; ///< device depth in [0,1]; 1 where there is no relief
    RgbImage colour;
    double seconds = 0; ///< drawing, up to glFinish
    double cpu_seconds = 0; ///< the process's processor time meanwhile, all threads; of planes of relief alone

    int width() const { return hit.width(); }
    int height() const { return hit.height(); }
    RayStatus status(std::size_t pixel) const { return RayStatus(int(counts[pixel][2])); }
};

} // namespace reliefbake

#pragma once
// Error and cost as pictures, in a colour map whose lightness grows evenly (viridis; Smith and van der Walt 2015).

#include "shaders-reference/renderer/rendering.h"

namespace reliefbake {

/// Colour of x in [0,1], dark blue to yellow, as 8-bit sRGB; values outside are clamped.
std::array<std::uint8_t, 3> viridis(double x);

/// |descent - the oracle's descent| on a logarithmic scale: 1e-5 of the relief's depth and less is darkest, all of it
/// brightest. Pixels without relief are black.
RgbImage error_picture(const Rendering& rendering, const Image<Quad>& oracle);

/// Steps of the march: 0 is darkest, `brightest` and more is brightest.
RgbImage steps_picture(const Rendering& rendering, double brightest);

} // namespace reliefbake

#pragma once
// The frame of a view that is measured: as many rays as asked for, nearly all of them at the view's angle.

#include "shaders-reference/renderer/relief_renderer.h"

namespace reliefbake {

/// A frame of about `rays` pixels, through a narrow field, of an endless plane where the map repeats. A clamped map shows one tile, which
/// grazing views foreshorten: the picture's shape follows, so that rays are not wasted on the background.
/// Angles in degrees, as View.
RenderOptions view_frame(const TexelGrid& grid, double angle, double azimuth, int rays);

} // namespace reliefbake

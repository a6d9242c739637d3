#pragma once
// From linear samples to a picture.

#include "bake/image.h"
#include "shaders-reference/renderer/rendering.h"

namespace reliefbake {

/// Averages blocks of factor x factor samples of linear colour and encodes them as 8-bit sRGB.
RgbImage resolve_picture(const Image<Quad>& linear, int factor);

} // namespace reliefbake

#pragma once
// Identity of a plane of pixels, whatever file it came from.

#include "bake/image.h"

#include <string>

namespace reliefbake {

/// XXH3-128 of width and height (little-endian 32-bit) and the plane's bytes, top row first; 32 hex digits.
std::string pixel_hash(const Image<float>& plane);

} // namespace reliefbake

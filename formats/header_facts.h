#pragma once
// The facts of an image file's header that OpenImageIO 2.4 hides.

namespace reliefbake {

/// A PNG that says it is sRGB: an sRGB chunk before its pixels. OpenImageIO reports every untagged PNG as sRGB.
bool png_has_srgb_chunk(int fd);

} // namespace reliefbake

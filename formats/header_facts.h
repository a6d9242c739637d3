#pragma once
// The facts of an image file that OpenImageIO 2.4 hides: read straight from the file, bounded in time and memory.

#include <cstdint>

namespace reliefbake {

/// A PNG that says it is sRGB: an sRGB chunk before its pixels. OpenImageIO reports every untagged PNG as sRGB.
bool png_has_srgb_chunk(int fd);

/// A JPEG's end-of-image marker is in its last 64 KiB. OpenImageIO fills what a truncated JPEG lacks with grey.
bool jpeg_has_end(int fd, std::uint64_t file_bytes);

} // namespace reliefbake

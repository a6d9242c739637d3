#pragma once
// What the first bytes of an image claim, for plans and predictions: no pixel is decoded, and no helper started.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace reliefbake {

struct ImageHeader {
    std::int64_t width = 0, height = 0; ///< as claimed: any numbers from 1 to 2^31 - 1
    int bits = 8;                       ///< of one sample
    bool single = false;                ///< one sample a pixel
};

/// Of png, tif (classic), exr, bmp, tga, pgm, ppm, pfm, hdr, jpg. None where the bytes make no sense or are of another format: the
/// decoder judges. Any bytes are safe; at most 1 MiB is read.
std::optional<ImageHeader> peek_image_header(const std::filesystem::path& path);

} // namespace reliefbake

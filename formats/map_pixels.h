#pragma once
// A map's planes as the interleaved samples of an image file.

#include "formats/map_layout.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace reliefbake {

/// Columns of the image: a map's, or twice as many where two parts stand side by side.
inline int image_width(const ReliefMap& map, const LayoutImage& image) { return map.grid.width * int(image.parts.size()); }

int sample_bytes_of(BitDepth bits);

/// Bytes that `interleave` fills.
std::uint64_t interleaved_bytes(const ReliefMap& map, const LayoutImage& image, BitDepth as);

/// Writes the image's samples, top row first, in the machine's byte order: unorm as integer codes, half as the nearest
/// half, float as it is. The map's planes hold code / max_code when `as` is unorm.
void interleave(const ReliefMap& map, const LayoutImage& image, BitDepth as, std::byte* out);

/// The same for an image whose channels are these planes, all of one size.
void interleave(std::span<const Image<float>* const> planes, BitDepth as, std::byte* out);

} // namespace reliefbake

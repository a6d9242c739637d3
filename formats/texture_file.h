#pragma once
// Texture containers that GPUs load as they are, with mip levels: DDS and KTX2, uncompressed, one, two or four channels.

#include "bake/bit_depth.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace reliefbake {

/// One mip level: width x height texels of their channels' samples, little-endian, top row first.
struct TextureLevel {
    int width, height;
    std::span<const std::byte> pixels;
};

/// Microsoft's DDS (learn.microsoft.com/windows/win32/direct3ddds): four channels of 8 bits by masks, as every reader
/// knows them; else the DX10 header names the format: R, RG or RGBA of 8 or 16 bits UNORM, or of 16 or 32 bits FLOAT. Level 0 first. It has no place for metadata.
std::vector<std::byte> encode_dds(BitDepth bits, int channels, std::span<const TextureLevel> levels);

/// Khronos KTX 2.0 (registry.khronos.org/KTX/specs/2.0): R, RG or RGBA; VK_FORMAT_R8..._UNORM, R16..._UNORM, R16..._SFLOAT or
/// R32..._SFLOAT, linear, not supercompressed.
/// `metadata` stands in the key/value data under "reliefbake", `writer` under "KTXwriter".
std::vector<std::byte> encode_ktx2(BitDepth bits, int channels, std::span<const TextureLevel> levels, const std::string& metadata,
                                   const std::string& writer);

} // namespace reliefbake

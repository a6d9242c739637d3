#pragma once
// Texture containers that GPUs load as they are, with mip levels: DDS and KTX2, uncompressed RGBA.

#include "bake/bit_depth.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace reliefbake {

/// One mip level: width x height texels of R, G, B, A samples, little-endian, top row first.
struct TextureLevel {
    int width, height;
    std::span<const std::byte> pixels;
};

/// Microsoft's DDS (learn.microsoft.com/windows/win32/direct3ddds): 8 bits by masks, as every reader knows it; with the DX10
/// header R16G16B16A16_UNORM, R16G16B16A16_FLOAT or R32G32B32A32_FLOAT. Level 0 first. It has no place for metadata.
std::vector<std::byte> encode_dds(BitDepth bits, std::span<const TextureLevel> levels);

/// Khronos KTX 2.0 (registry.khronos.org/KTX/specs/2.0): VK_FORMAT_R8G8B8A8_UNORM, R16G16B16A16_UNORM, R16G16B16A16_SFLOAT or
/// R32G32B32A32_SFLOAT, linear, not supercompressed.
/// `metadata` stands in the key/value data under "reliefbake", `writer` under "KTXwriter".
std::vector<std::byte> encode_ktx2(BitDepth bits, std::span<const TextureLevel> levels, const std::string& metadata,
                                   const std::string& writer);

} // namespace reliefbake

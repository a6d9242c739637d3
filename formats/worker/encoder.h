#pragma once
// Encoding with OpenImageIO, to memory.

#include <OpenImageIO/imageio.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace reliefbake::worker {

/// Size, channels, type and attributes that a request asks for.
OIIO::ImageSpec spec_of(const nlohmann::json& request);

/// Encodes interleaved `pixels` as `request` (image_worker.h, encode) says. Throws Refusal. To memory, because on a full
/// disk OpenImageIO 2.4 reports success for PNG, TGA and BMP.
std::vector<unsigned char> encode(const nlohmann::json& request, std::span<const std::byte> pixels);

} // namespace reliefbake::worker

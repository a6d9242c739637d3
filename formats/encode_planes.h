#pragma once
// Planes of one size to the bytes of an image file, by the helper process: PNG, TIFF, EXR and TGA.

#include "bake/bit_depth.h"
#include "bake/error.h"
#include "bake/image.h"
#include "formats/map_format.h"
#include "formats/shared_memory.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace reliefbake {

struct PlanesImage {
    std::vector<std::string> channels;           ///< names, one a plane
    std::span<const Image<float>* const> planes; ///< code / largest code where `bits` is unorm
    BitDepth bits;
    nlohmann::json attributes;                   ///< metadata_attributes
};

/// `path` names the file in messages, and its format. Errors: write_failed, internal.
Result<SharedMemory> encode_planes(const std::filesystem::path& path, MapFormat format, const PlanesImage& image, int threads);

} // namespace reliefbake

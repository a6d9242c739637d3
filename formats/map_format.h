#pragma once
// File formats that can hold a map, and what each can hold.

#include "bake/bit_depth.h"
#include "bake/error.h"
#include "bake/relief_map.h"

#include <filesystem>

namespace reliefbake {

enum class MapFormat { png, tiff, openexr, targa, dds, ktx2 };

/// By the file's extension; usage error for any other.
Result<MapFormat> map_format_of(const std::filesystem::path& path);

} // namespace reliefbake

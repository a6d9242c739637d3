#pragma once
// File formats that can hold a map, and what each can hold.

#include "bake/bit_depth.h"
#include "bake/error.h"
#include "bake/relief_map.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <initializer_list>

namespace reliefbake {

enum class MapFormat { png, tiff, openexr, targa, dds, ktx2 };

/// By the file's extension; usage error for any other.
Result<MapFormat> map_format_of(const std::filesystem::path& path);

/// EncodeRequest's words for the formats and bit depths that the helper writes.
const char* writer_name(MapFormat format);
const char* sample_name(BitDepth bits);

/// Where each format that the helper writes keeps metadata that survives: PNG a tEXt chunk, EXR an attribute (and the facts of
/// `words` one by one, for people with exrheader), TIFF ImageDescription; TGA has 324 characters, too few. ASCII: PNG's tEXt is
/// Latin-1.
nlohmann::json metadata_attributes(MapFormat format, const nlohmann::json& facts, std::initializer_list<const char*> words);

/// Those of a relief map.
nlohmann::json map_attributes(MapFormat format, const nlohmann::json& facts);

} // namespace reliefbake

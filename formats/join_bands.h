#pragma once
// Bands of rows to one map.

#include "bake/error.h"
#include "formats/atomic_file.h"
#include "formats/band_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <span>
#include <vector>

namespace reliefbake {

/// Refuses (usage) files that are not written row by row: all but EXR and TIFF, and a TIFF of more than 4000 MiB before it is
/// compressed, of which its 32-bit offsets may not reach the end.
Result<void> check_streamed_format(const std::filesystem::path& path, std::uint64_t pixel_bytes);

/// Puts bands into the order of their rows, and refuses (bad_data) those of different maps, and rows that are missing or there twice.
/// `bands` is not empty.
Result<void> order_bands(std::vector<BandReader>& bands);

/// Writes the map of ordered bands, with the bytes that write_map gives it, and returns its metadata. Errors: usage
/// (check_streamed_format, check_map_format), those of BandReader::read, cannot_create, write_failed, internal.
Result<nlohmann::json> write_joined_map(const std::filesystem::path& path, std::span<const BandReader> bands, FileBatch& batch, int threads);

} // namespace reliefbake

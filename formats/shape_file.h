#pragma once
// Shape maps as files: R, G the gradient, B the distance, A the shape, and what they mean (docs/FORMATS.md).

#include "bake/error.h"
#include "bake/shape_map.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>

namespace reliefbake {

/// Every fact of a shape map, keys as in docs/FORMATS.md; `explain --json` prints it.
nlohmann::json to_json(const ShapeMapInfo& info, const TexelGrid& grid);

/// Refuses (usage) what the format, by the file's extension, cannot hold, as check_map_format does.
Result<void> check_shape_format(const std::filesystem::path& path, const ShapeMapInfo& info);

/// Encodes in memory and writes atomically, as write_map does: same map, same bytes. TGA and DDS keep no metadata: such a file is
/// not read again.
/// Errors: usage, cannot_create, write_failed, internal.
Result<void> write_shape_map(const std::filesystem::path& path, const ShapeMap& map, int threads = 1);

/// Reads a shape map that write_shape_map wrote as PNG, TIFF or EXR.
/// Errors: no_input; bad_data (undecodable, no shape map, damaged or missing metadata, values that mean nothing).
Result<ShapeMap> read_shape_map(const std::filesystem::path& path, std::uint64_t max_bytes = 0);

} // namespace reliefbake

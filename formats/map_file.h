#pragma once
// Baked maps as files: channel layout, bit depth and metadata (docs/FORMATS.md).

#include "bake/error.h"
#include "bake/relief_map.h"

#include <filesystem>
#include <optional>
#include <string>

namespace reliefbake {

/// Refuses (usage) what the format, by the file's extension, cannot hold: png 8|16, tif 8|16|half|float,
/// exr half|float, tga 8; layout `named` is for exr alone. Called before the bake, so that no work is lost.
Result<void> check_map_format(const std::filesystem::path& path, BitDepth bits, ChannelLayout layout);

/// Encodes in memory and writes atomically: `path` is complete, or what it was before. Same map, same bytes.
Result<void> write_map(const std::filesystem::path& path, const ReliefMap& map);

/// What to assume where a file does not say (maps baked by others), or to insist on. Given values win over metadata.
struct MapHints {
    std::optional<Metric> metric;
    std::optional<ConeEncoding> encoding;
    std::optional<SurfaceModel> surface;
    std::optional<NormalY> normal_y;
    std::optional<Wrap> wrap_x, wrap_y;
    std::optional<float> cone_max;
    std::optional<double> depth_scale;
    std::string channel_order = ""; ///< e.g. "RGBA" = nx, ny, cone, depth; "--BA": letters name the file's channels
                                    ///< that hold nx, ny, cone, depth; '-' = absent. Empty: as the metadata says
    bool alpha_is_height = false;   ///< the depth channel holds height
    std::uint64_t max_bytes = 0;
};

/// Errors: no_input, bad_data (not a map: says which metadata is missing and which flags would supply it).
Result<ReliefMap> read_map(const std::filesystem::path& path, const MapHints& hints = {});

} // namespace reliefbake

#pragma once
// Bump maps as files: which channels hold what, and what they mean (docs/FORMATS.md).

#include "bake/bump_map.h"
#include "bake/error.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// One image file of a bump map.
struct BumpImage {
    std::string suffix;                ///< behind the stem of the map's name: "", or "_b"
    std::vector<std::string> channels; ///< names in the file
    int first = 0;                     ///< plane of the first channel; a channel more than there are planes holds the depth
};

/// The files of a map, the one with the map's own name first. derivative: R, G, B = du, dv, depth; normal: R, G, B, A = x, y, z,
/// depth; horizon: azimuths 0 to 3 and 4 to 7 in two files; named: one EXR with bump.du, relief.nx, horizon.a0, relief.depth, ...
std::vector<BumpImage> bump_images(const BumpMapInfo& info);

/// The word of a kind in metadata, "derivative", "normal" or "horizon", and back.
const char* word_of(BumpKind kind);
std::optional<BumpKind> bump_kind_of(const std::string& word);

/// Every fact, keys as in docs/FORMATS.md; `explain --json` prints it.
nlohmann::json to_json(const BumpMapInfo& info, const TexelGrid& grid);

/// Refuses (usage) what the format, by the file's extension, or the layout cannot hold: png 8|16, tif 8|16|half|float,
/// exr half|float, tga 8.
Result<void> check_bump_format(const std::filesystem::path& path, const BumpMapInfo& info);

/// Encodes in memory and writes atomically, as write_map does: same map, same bytes; two files appear together. TGA keeps
/// no metadata: such a file is not read again. Errors: usage, cannot_create, write_failed, internal.
Result<void> write_bump_map(const std::filesystem::path& path, const BumpMap& map, int threads = 1);

/// Reads a bump map that write_bump_map wrote as PNG, TIFF or EXR.
/// Errors: no_input; bad_data (undecodable, no bump map, damaged or missing metadata, values that mean nothing).
Result<BumpMap> read_bump_map(const std::filesystem::path& path, std::uint64_t max_bytes = 0);

} // namespace reliefbake

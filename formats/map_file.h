#pragma once
// Baked maps as files: channel layout, bit depth and metadata (docs/FORMATS.md).

#include "bake/error.h"
#include "bake/relief_map.h"
#include "formats/atomic_file.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace reliefbake {

/// Refuses (usage) what the format, by the file's extension, cannot hold: png 8|16, tif 8|16|half|float,
/// exr half|float, tga 8, dds and ktx2 8|16|half|float; layout `named` is for exr alone. Called before the bake, so that no work is lost.
Result<void> check_map_format(const std::filesystem::path& path, BitDepth bits, ChannelLayout layout);

/// The same, and refuses (usage) what the layout cannot hold: kinds, sectors and levels of a stack (map_layout.h).
Result<void> check_map_format(const std::filesystem::path& path, const ReliefMapInfo& info);

/// Encodes in memory and writes atomically: `path` is complete, or what it was before. Same map, same bytes, on any day
/// (SOURCE_DATE_EPOCH is honoured). Half stores what the channels hold when a half can, else the nearest half.
/// TGA keeps no metadata: reading it back needs every hint. Layout `pair`: two files, `path` and one whose stem ends in _b,
/// which appear together. A map with several cones a texel in any layout but `named` leaves out depth and normals. `threads` compress an EXR; they change no byte.
/// Errors: usage, cannot_create, write_failed, internal.
Result<void> write_map(const std::filesystem::path& path, const ReliefMap& map, int threads = 1);
/// The same into a batch: nothing appears before it is published.
Result<void> write_map(const std::filesystem::path& path, const ReliefMap& map, FileBatch& batch, int threads);

/// Whether the format, by the file's extension, keeps mip levels in one file: exr, tif, dds, ktx2.
bool holds_mips(const std::filesystem::path& path);

/// Where level n of a chain goes in a format that does not: `path` itself for level 0, then {stem}_mip{n}{extension}.
std::filesystem::path mip_path(const std::filesystem::path& path, int level);

/// Writes a chain (bake_depth_mips: each level half the one before, down to 1 x 1) as write_map does: in one file, whose
/// metadata is that of level 0, or in numbered files of their own. Layout `side` is refused (usage): halves side by side
/// would meet in the smaller levels.
Result<void> write_map_levels(const std::filesystem::path& path, std::span<const ReliefMap> levels, int threads = 1);
Result<void> write_map_levels(const std::filesystem::path& path, std::span<const ReliefMap> levels, FileBatch& batch, int threads);

/// The names of the files that write_map, or with `mips` write_map_levels, may give a map of such facts; of numbered levels as many
/// as the largest map has.
std::vector<std::filesystem::path> map_files(const std::filesystem::path& path, const ReliefMapInfo& info, bool mips);

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
    bool holes = false;             ///< depth 1 is a hole
    std::filesystem::path relief;   ///< a map of kind cone that holds the depth and the normals of a map without them
    int level = 0;                  ///< mip level to read, of an EXR or TIFF that has some; 0 the largest
    bool cones_suffice = false;     ///< without `relief`, leave depth and normals empty instead of refusing (explain)
    std::uint64_t max_bytes = 0;    ///< as ReadOptions::max_bytes
};

/// Reads any allowed image as a map; the file's metadata and the hints say how. Channels absent by hint are empty images.
/// Depth and normals of a map that holds cones alone come from `hints.relief`, baked from the same
/// heights: same size, wrap, pixel aspect, bits and source. A kind of a later version is refused, or with cones_suffice read
/// without planes, unless a channel order insists on it.
/// A mip level has the proportions of level 0, and no statistics: the file tells only those of level 0. DDS and KTX2 are not
/// read (bad_data).
/// What only rendering wants has defaults: normal_y gl, depth_scale 0.1, pixel aspect 1.
/// Errors: no_input; bad_data (undecodable, damaged metadata, values that mean nothing, or facts missing: names the flags
/// that supply them); usage (channel_order, a relief file that is missing or not wanted).
Result<ReliefMap> read_map(const std::filesystem::path& path, const MapHints& hints = {});

} // namespace reliefbake

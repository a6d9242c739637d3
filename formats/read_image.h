#pragma once
// Decoding of untrusted image files: one plane out of a PNG, TIFF, EXR, TGA, BMP, JPEG, HDR, PGM/PPM or PFM file.
// Runs in a helper process with limits (image_worker.h); no input can crash or hang the caller.

#include "bake/error.h"
#include "bake/image.h"

#include <cstdint>
#include <filesystem>
#include <memory_resource>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

struct ReadOptions {
    /// R, G, B, A, Y (luminance, Rec. 709 on the stored numbers), a channel's full name, or empty: the only channel,
    /// else luminance (--channel)
    std::string channel;
    /// Budget for the decoded image in bytes; 0: 1 GiB, and 1000 x the file's size above 64 MiB (--max-bytes)
    std::uint64_t max_bytes = 0;
    bool prefer_alpha = false; ///< without `channel`, A where there is one, before luminance
};

struct SourceImage {
    Image<float> plane;       ///< integers as value / largest value, floats as stored (NaN and Inf too)
    std::string format;       ///< png, tiff, openexr, ...
    std::vector<std::string> channel_names;
    std::string channel;      ///< the channel taken: a name, or "luminance"
    bool is_integer = true;
    int bit_depth = 8;        ///< of one stored sample
    bool srgb_tagged = false; ///< the file claims sRGB: suspicious for heights; the caller warns
    std::optional<float> no_data; ///< GeoTIFF GDAL_NODATA
    std::string pixel_hash;   ///< XXH3-128 of width, height and the plane's bytes, 32 hex digits
};

/// Errors: no_input (cannot open), bad_data (cannot decode, not an allowed format, over the budget, no such channel:
/// the message lists those there are).
Result<SourceImage> read_image(const std::filesystem::path& path, const ReadOptions& options);

/// The same into `storage`, row by row (DecodeSession::open_rows): no other memory grows with the image.
Result<SourceImage> read_image_into(std::pmr::memory_resource& storage, const std::filesystem::path& path, const ReadOptions& options);

/// Sides of an EXR or TIFF, and nothing else (usage). Errors as read_image_into.
struct ImageSides {
    int width, height;
};
Result<ImageSides> look_at_sides(const std::filesystem::path& path, const ReadOptions& options);

} // namespace reliefbake

#pragma once
// One image file on its way through the helper process: open, look at the claims, then take float rows.

#include "bake/error.h"
#include "formats/image_gate.h"
#include "formats/image_worker.h"
#include "formats/sniff.h"

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace reliefbake {

class DecodeSession {
  public:
    /// Opens `path`, or a mip level of an EXR or TIFF, in the worker and passes its header through check_claims (for `planes` float planes kept by the
    /// caller). Holds the worker until it is destroyed. Errors: no_input, bad_data, internal; usage (a level of a format
    /// without levels).
    static Result<DecodeSession> open(const std::filesystem::path& path, std::uint64_t max_bytes, int planes,
                                      int level = 0);

    /// The same for a caller that keeps no plane in memory: rows of tiles are decoded and handed on, and only they count; the budget
    /// is max_bytes, or 1000 times the file's size, 64 MiB at least. EXR and TIFF alone (usage).
    static Result<DecodeSession> open_rows(const std::filesystem::path& path, std::uint64_t max_bytes);

    /// Refuses (bad_data) when the caller keeps `planes` float planes after all and the budget has no room for them.
    Result<void> check_planes(int planes) const;

    const ImageClaims& claims() const { return claims_; }
    ImageFormat format() const { return format_; }
    std::optional<float> no_data() const { return no_data_; } ///< GeoTIFF GDAL_NODATA

    /// Receives rows [y, y + rows) of the channels asked for, interleaved.
    using TakeRows = std::function<void(int y, int rows, const float* samples)>;

    /// Decodes `channels` (indices into claims().channels) from top to bottom; integers as value / largest value,
    /// floats as stored. Memory here: one block of about 4 MiB. Once per session. Errors: bad_data.
    Result<void> read(std::span<const int> channels, const TakeRows& take);

    struct InputFile;

  private:
    DecodeSession(const std::filesystem::path& path, const InputFile& file, ImageFormat format);
    /// Sends the header through the worker and the gate.
    Result<void> begin(const InputFile& file, int seconds, int planes);
    Result<void> look_closer(const InputFile& file);

    std::string name_;
    std::uint64_t file_bytes_ = 0, max_bytes_ = 0;
    ImageFormat format_{};
    int level_ = 0;
    ImageClaims claims_;
    std::optional<float> no_data_;
    std::uint64_t memory_ = 0;
    std::unique_lock<std::mutex> lock_;
};

} // namespace reliefbake

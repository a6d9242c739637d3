#pragma once
// The gate between an image file's header and its first pixel: what the header claims against what the user allows.

#include "bake/error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbake {

/// How one stored sample is laid out in memory once decoded.
enum class SampleType { uint8, int8, uint16, int16, uint32, int32, half, float32, float64 };

/// What an opened image's header says. Untrusted until check_claims has passed it.
struct ImageClaims {
    std::int64_t width = 0; ///< of the data window
    std::int64_t height = 0;
    std::int64_t depth = 1;
    std::int64_t top_width = 0; ///< of mip level 0, where this is another
    std::int64_t top_height = 0;
    std::int64_t tile_width = 0; ///< 0: not tiled
    std::int64_t tile_height = 0;
    SampleType sample = SampleType::uint8;
    int bit_depth = 8;        ///< significant bits of one stored sample
    bool deep = false;
    bool srgb_tagged = false; ///< the file says sRGB: chunk, Exif or ICC profile
    std::vector<std::string> channels;
    std::string relief;      ///< our metadata (map_json.h); empty when there is none
};

int sample_bytes(SampleType sample);
inline bool is_integer(SampleType sample) { return sample < SampleType::half; }

/// Largest side of an image: the map side that GPUs of today sample, times four.
constexpr std::int64_t max_side = 65536;
constexpr std::int64_t max_channels = 1024;

/// Bytes that decoding a file of `file_bytes` may claim: `max_bytes`, or if 0: 1 GiB, and 1000 x the file's size above
/// 64 MiB (deflate and run-length codes reach 1030:1 on constant pixels alone).
std::uint64_t decode_budget(std::uint64_t file_bytes, std::uint64_t max_bytes);

/// Bytes of all samples as decoded. Saturates instead of overflowing.
std::uint64_t decoded_bytes(const ImageClaims& claims);

/// Refuses (bad_data) what no height map or relief map can be and what exceeds the budget. `planes` float planes are
/// what the caller keeps. `name` is the file, for messages.
Result<void> check_claims(const ImageClaims& claims, std::uint64_t file_bytes, std::uint64_t max_bytes, int planes,
                          const std::string& name);

} // namespace reliefbake

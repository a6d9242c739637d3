#pragma once
// Pixels to the bytes of an image file, in the helper process.

#include "bake/error.h"
#include "formats/shared_memory.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace reliefbake {

/// What a file is to hold. Sample types by OpenImageIO's names: uint8, uint16, half, float.
struct EncodeRequest {
    std::string writer;                ///< png, tiff, openexr, targa
    int width = 0;
    int height = 0;
    std::vector<std::string> channels; ///< names, in the order of the samples
    std::string sample;                ///< as stored in the file
    std::string pixels;                ///< as handed over; float becomes half by rounding to nearest
    nlohmann::json attributes = nlohmann::json::object(); ///< strings and integers
    std::vector<std::pair<int, int>> mips{}; ///< width, height of levels 1, 2, ...; EXR and TIFF, which are tiled then
    int threads = 1; ///< for formats whose blocks are compressed one by one (EXR); changes no byte
};

/// Bytes that `request.pixels` samples of the whole image take, all its levels one behind the other.
std::uint64_t pixel_bytes(const EncodeRequest& request);

/// Encodes `pixels` (pixel_bytes(request) of them, interleaved, top row first); always untagged (no colour space), never
/// with a clock or a command line in it: the time is SOURCE_DATE_EPOCH or 1970. Same request, same bytes.
/// `name` is the file, for messages. Errors: write_failed, internal.
Result<SharedMemory> encode_image(const EncodeRequest& request, const SharedMemory& pixels, const std::string& name);

/// The request as the helper is told it, less `do`: with compression, time and all that every file of ours has.
nlohmann::json encode_message(const EncodeRequest& request);

} // namespace reliefbake

#pragma once
// Rendered pictures as files.

#include "bake/error.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace reliefbake {

/// A PNG of 8-bit samples, as write_png has it; `name` is for messages. Errors: write_failed, internal (no helper).
Result<std::string> encode_png(int width, int height, int channels, std::span<const std::uint8_t> samples, const std::string& name);

/// Writes 8-bit samples, interleaved, top row first, as an untagged PNG; 1 channel: grey, 2: grey + alpha, 3: RGB,
/// 4: RGBA, alpha unassociated. Atomic; same pixels, same bytes. `samples` holds width * height * channels bytes.
/// Errors: cannot_create, write_failed, internal (no helper).
Result<void> write_png(const std::filesystem::path& path, int width, int height, int channels,
                       std::span<const std::uint8_t> samples);

} // namespace reliefbake

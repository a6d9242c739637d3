#pragma once
// Whether a file is the one it was: a stamp that costs one system call, and hashes that cost reading it.

#include "bake/error.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace reliefbake {

/// What changes with every write. Equal stamps: the same bytes, but for a write within one tick of the file system's clock;
/// different stamps say nothing.
struct FileStamp {
    std::uint64_t size = 0, inode = 0;
    std::int64_t modified = 0, changed = 0; ///< nanoseconds since 1970 (mtime, ctime)
    bool operator==(const FileStamp&) const = default;
};

/// None where there is no regular file.
std::optional<FileStamp> stamp_of(const std::filesystem::path& path);

/// XXH3-128 of the file's bytes, 32 hex digits. Errors: no_input.
Result<std::string> hash_of_bytes(const std::filesystem::path& path);

/// The same of a text.
std::string hash_of_text(const std::string& text);

/// XXH3-128 of an image as decoded: size, samples of every channel, their names and type, no-data, and whether it says sRGB.
/// Equal for two files that no bake can tell apart, however they are compressed. Memory: one block of rows.
/// Errors: no_input, bad_data (no image, or one that cannot be decoded).
Result<std::string> hash_of_image(const std::filesystem::path& path, std::uint64_t max_bytes);

} // namespace reliefbake

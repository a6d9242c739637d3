#pragma once
// Which reader a file gets: decided by its first bytes, never by whichever reader of the library happens to accept it.

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace reliefbake {

enum class ImageFormat { png, tiff, openexr, hdr, jpeg, targa, bmp, pnm };

/// OpenImageIO's name of the reader.
std::string_view reader_name(ImageFormat format);

/// For messages: what is accepted.
constexpr std::string_view accepted_formats = "png, tif, exr, hdr, jpg, tga, bmp, pgm, ppm, pfm";

/// The format that the first bytes (up to 18 are looked at) announce. TGA has no magic number: it is taken when `path`
/// ends in .tga and its fixed header fields are possible ones.
std::optional<ImageFormat> sniff_format(std::span<const std::byte> head, const std::filesystem::path& path);

} // namespace reliefbake

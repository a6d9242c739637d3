#pragma once
// PNG decoding by libpng itself: the second opinion on what OpenImageIO wrote or read.

#include <png.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace reliefbake::test {

struct RawPng {
    int width = 0, height = 0, channels = 0, bits = 0;
    bool tagged = false;              ///< gAMA, sRGB, cHRM or iCCP present
    std::vector<std::uint16_t> codes; ///< interleaved, as stored; below 8 bits and palettes are refused
};

inline RawPng decode_with_libpng(const std::filesystem::path& path) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (!file) throw std::runtime_error("cannot open " + path.string());
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);

    RawPng raw;
    raw.width = int(png_get_image_width(png, info));
    raw.height = int(png_get_image_height(png, info));
    raw.channels = png_get_channels(png, info);
    raw.bits = png_get_bit_depth(png, info);
    raw.tagged = png_get_valid(png, info, PNG_INFO_gAMA | PNG_INFO_sRGB | PNG_INFO_cHRM | PNG_INFO_iCCP) != 0;
    png_bytepp rows = png_get_rows(png, info);
    for (int y = 0; y < raw.height; ++y)
        for (int i = 0; i < raw.width * raw.channels; ++i)
            raw.codes.push_back(raw.bits == 16 ? reinterpret_cast<std::uint16_t*>(rows[y])[i] : rows[y][i]);
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return raw;
}

} // namespace reliefbake::test

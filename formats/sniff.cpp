#include "formats/sniff.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace reliefbake {

namespace {

using namespace std::string_view_literals;

struct Magic {
    std::string_view bytes;
    ImageFormat format;
};

// Big TIFF is the version 43 pair. P1..P7 are the Netpbm family of which OpenImageIO reads 1..6, PF and Pf.
constexpr Magic magics[] = {
    {"\x89PNG\r\n\x1a\n"sv, ImageFormat::png}, {"II*\0"sv, ImageFormat::tiff},      {"MM\0*"sv, ImageFormat::tiff},
    {"II+\0"sv, ImageFormat::tiff},            {"MM\0+"sv, ImageFormat::tiff},      {"v/1\x01"sv, ImageFormat::openexr},
    {"#?RADIANCE"sv, ImageFormat::hdr},        {"#?RGBE"sv, ImageFormat::hdr},      {"\xff\xd8\xff"sv, ImageFormat::jpeg},
    {"BM"sv, ImageFormat::bmp},                {"P1"sv, ImageFormat::pnm},          {"P2"sv, ImageFormat::pnm},
    {"P3"sv, ImageFormat::pnm},                {"P4"sv, ImageFormat::pnm},          {"P5"sv, ImageFormat::pnm},
    {"P6"sv, ImageFormat::pnm},                {"PF"sv, ImageFormat::pnm},          {"Pf"sv, ImageFormat::pnm},
};

bool has_extension(const std::filesystem::path& path, std::string_view wanted) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension == wanted;
}

/// Truevision TGA 2.0 section "TGA file header": colour-map type, image type, bits per pixel.
bool possible_targa(std::string_view head) {
    if (head.size() < 18) return false;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(head[i]); };
    constexpr std::string_view image_types = "\1\2\3\11\12\13"sv;
    constexpr std::string_view pixel_bits = "\10\17\20\30\40"sv;
    return byte(1) <= 1 && image_types.find(head[2]) != head.npos && pixel_bits.find(head[16]) != head.npos;
}

} // namespace

std::string_view reader_name(ImageFormat format) {
    constexpr std::string_view names[] = {"png", "tiff", "openexr", "hdr", "jpeg", "targa", "bmp", "pnm"};
    return names[int(format)];
}

std::optional<ImageFormat> sniff_format(std::span<const std::byte> head, const std::filesystem::path& path) {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    for (const Magic& magic : magics)
        if (text.starts_with(magic.bytes)) return magic.format;
    if (has_extension(path, ".tga") && possible_targa(text)) return ImageFormat::targa;
    return std::nullopt;
}

} // namespace reliefbake

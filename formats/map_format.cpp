#include "formats/map_format.h"

#include "formats/map_file.h"
#include "formats/map_layout.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace reliefbake {

namespace {

bool can_hold(MapFormat format, BitDepth bits) {
    switch (format) {
    case MapFormat::png: return is_unorm(bits);
    case MapFormat::tiff: return true;
    case MapFormat::openexr: return !is_unorm(bits);
    case MapFormat::targa: return bits == BitDepth::unorm8;
    case MapFormat::dds:
    case MapFormat::ktx2: return true;
    }
    return false;
}

const char* bits_held(MapFormat format) {
    constexpr const char* held[] = {"8 or 16 bits", "8 or 16 bits, half or float", "half or float", "8 bits", "any bits", "any bits"};
    return held[int(format)];
}

} // namespace

Result<MapFormat> map_format_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".png") return MapFormat::png;
    if (extension == ".tif" || extension == ".tiff") return MapFormat::tiff;
    if (extension == ".exr") return MapFormat::openexr;
    if (extension == ".tga") return MapFormat::targa;
    if (extension == ".dds") return MapFormat::dds;
    if (extension == ".ktx2") return MapFormat::ktx2;
    return fail(ErrorCode::usage, path.string() + ": maps are written as .png, .tif, .exr, .tga, .dds or .ktx2, not as '" + extension + "'");
}

const char* writer_name(MapFormat format) {
    constexpr const char* writers[] = {"png", "tiff", "openexr", "targa"};
    return writers[int(format)];
}

const char* sample_name(BitDepth bits) {
    constexpr const char* samples[] = {"uint8", "uint16", "half", "float"};
    return samples[int(bits)];
}

nlohmann::json metadata_attributes(MapFormat format, const nlohmann::json& facts, std::initializer_list<const char*> words) {
    const std::string text = facts.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    nlohmann::json attributes = nlohmann::json::object();
    if (format == MapFormat::png || format == MapFormat::openexr) attributes["reliefbake"] = text;
    if (format == MapFormat::tiff) attributes["ImageDescription"] = text;
    if (format == MapFormat::openexr)
        for (const char* key : words) attributes[std::string("reliefbake.") + key] = facts[key];
    return attributes;
}

Result<void> check_map_format(const std::filesystem::path& path, BitDepth bits, ChannelLayout layout) {
    const Result<MapFormat> format = map_format_of(path);
    if (!format) return tl::unexpected(format.error());
    if (layout == ChannelLayout::named && *format != MapFormat::openexr)
        return fail(ErrorCode::usage, path.string() + ": only .exr has named channels; use --exr-layout rgba");
    if (!can_hold(*format, bits))
        return fail(ErrorCode::usage, path.string() + ": this format holds " + bits_held(*format) + "; change --bits or the extension");
    return {};
}

Result<void> check_map_format(const std::filesystem::path& path, const ReliefMapInfo& info) {
    if (Result<void> checked = check_map_format(path, info.bits, info.layout); !checked) return checked;
    const Result<void> layout = check_layout(info);
    const std::size_t channels = layout ? written_image(layout_images(info)[0]).channels.size() : 0;
    const MapFormat format = *map_format_of(path);
    if (channels == 3 && (format == MapFormat::dds || format == MapFormat::ktx2))
        return fail(ErrorCode::usage, path.string() + ": GPUs have no texture of three channels; leave out the normals too, or nothing");
    if (channels == 2 && format == MapFormat::targa) return fail(ErrorCode::usage, path.string() + ": a TGA has one, three or four channels; choose another format");
    if (layout) return {};
    return fail(layout.error().code, path.string() + ": " + layout.error().message);
}

bool holds_mips(const std::filesystem::path& path) {
    const Result<MapFormat> format = map_format_of(path);
    return format && *format != MapFormat::png && *format != MapFormat::targa;
}

std::filesystem::path mip_path(const std::filesystem::path& path, int level) {
    if (level == 0) return path;
    return path.parent_path() / (path.stem().string() + "_mip" + std::to_string(level) + path.extension().string());
}

nlohmann::json map_attributes(MapFormat format, const nlohmann::json& facts) {
    return metadata_attributes(format, facts, {"kind", "family", "metric", "encoding", "surface", "normal_y", "guarantee"});
}

} // namespace reliefbake

#include "formats/shape_file.h"

#include "formats/atomic_file.h"
#include "formats/encode_planes.h"
#include "formats/map_file.h"
#include "formats/map_format.h"
#include "formats/map_pixels.h"
#include "formats/shape_json.h"
#include "formats/texture_file.h"

#include <array>
#include <cstddef>
#include <vector>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

std::array<const Image<float>*, 4> planes_of(const ShapeMap& map) {
    return {&map.gradient_x, &map.gradient_y, &map.distance, &map.shape};
}

std::string metadata_text(const ShapeMap& map) {
    return to_json(map.info, map.grid).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

/// PNG, TIFF, EXR and TGA, by OpenImageIO in the helper.
Result<void> write_by_helper(const fs::path& path, MapFormat format, const ShapeMap& map, int threads) {
    const auto planes = planes_of(map);
    const auto attributes = metadata_attributes(format, to_json(map.info, map.grid), {"kind", "model", "method", "guarantee"});
    const Result<SharedMemory> file = encode_planes(path, format, {shape_channels(map.info), planes, map.info.bits, attributes}, threads);
    if (!file) return tl::unexpected(file.error());
    return write_file_atomically(path, file->bytes());
}

/// DDS and KTX2, by us.
Result<void> write_texture(const fs::path& path, MapFormat format, const ShapeMap& map) {
    const BitDepth bits = map.info.bits;
    std::vector<std::byte> pixels(map.shape.size() * 4 * std::size_t(sample_bytes_of(bits)));
    interleave(planes_of(map), bits, pixels.data());
    const TextureLevel level{map.grid.width, map.grid.height, pixels};
    if (format == MapFormat::dds) return write_file_atomically(path, encode_dds(bits, 4, {&level, 1}));
    return write_file_atomically(path, encode_ktx2(bits, 4, {&level, 1}, metadata_text(map), "reliefbake " RELIEFBAKE_VERSION));
}

} // namespace

Result<void> check_shape_format(const fs::path& path, const ShapeMapInfo& info) {
    return check_map_format(path, info.bits, info.named ? ChannelLayout::named : ChannelLayout::rgba);
}

Result<void> write_shape_map(const fs::path& path, const ShapeMap& map, int threads) {
    if (Result<void> checked = check_shape_format(path, map.info); !checked) return checked;
    const MapFormat format = *map_format_of(path);
    if (format == MapFormat::dds || format == MapFormat::ktx2) return write_texture(path, format, map);
    return write_by_helper(path, format, map, threads);
}

} // namespace reliefbake

#include "formats/map_file.h"

#include "formats/atomic_file.h"
#include "formats/encode_image.h"
#include "formats/map_format.h"
#include "formats/map_json.h"

#include <array>
#include <cassert>
#include <cstdint>

namespace reliefbake {

namespace {

using Planes = std::array<const Image<float>*, 4>;

/// Interleaves the planes as codes (unorm) or as they are.
template <class Sample>
void interleave(const Planes& planes, float scale, Sample* out) {
    for (std::size_t c = 0; c < planes.size(); ++c)
        for (std::size_t i = 0; i < planes[c]->size(); ++i) {
            const float value = (*planes[c])[i];
            if constexpr (std::is_integral_v<Sample>) {
                assert(value >= 0 && value <= 1);
                out[4 * i + c] = Sample(value * scale + 0.5f); // value is code / max_code up to rounding
            } else {
                out[4 * i + c] = value;
            }
        }
}

void interleave_as(BitDepth bits, const Planes& planes, std::byte* out) {
    const float scale = float(max_code(bits));
    if (bits == BitDepth::unorm8) interleave(planes, scale, reinterpret_cast<std::uint8_t*>(out));
    else if (bits == BitDepth::unorm16) interleave(planes, scale, reinterpret_cast<std::uint16_t*>(out));
    else interleave(planes, scale, reinterpret_cast<float*>(out));
}

/// Where each format keeps a text that survives: PNG a tEXt chunk, EXR an attribute (and the important words one by one,
/// for people with exrheader), TIFF ImageDescription; TGA has 324 characters, too few.
nlohmann::json metadata_attributes(MapFormat format, const ReliefMap& map) {
    const nlohmann::json facts = to_json(map.info, map.grid);
    const std::string text = facts.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace); // ASCII: tEXt is Latin-1
    nlohmann::json attributes = nlohmann::json::object();
    if (format == MapFormat::png || format == MapFormat::openexr) attributes["reliefbake"] = text;
    if (format == MapFormat::tiff) attributes["ImageDescription"] = text;
    if (format == MapFormat::openexr)
        for (const char* key : {"kind", "metric", "encoding", "surface", "normal_y", "guarantee"})
            attributes[std::string("reliefbake.") + key] = facts[key];
    return attributes;
}

EncodeRequest request_for(MapFormat format, const ReliefMap& map) {
    constexpr const char* writers[] = {"png", "tiff", "openexr", "targa"};
    constexpr const char* samples[] = {"uint8", "uint16", "half", "float"};
    const auto names = channel_names(map.info.layout);
    EncodeRequest request;
    request.writer = writers[int(format)];
    request.width = map.grid.width;
    request.height = map.grid.height;
    request.channels.assign(names.begin(), names.end());
    request.sample = samples[int(map.info.bits)];
    request.pixels = is_unorm(map.info.bits) ? request.sample : "float";
    request.attributes = metadata_attributes(format, map);
    return request;
}

} // namespace

Result<void> write_map(const std::filesystem::path& path, const ReliefMap& map, int threads) {
    if (Result<void> checked = check_map_format(path, map.info.bits, map.info.layout); !checked) return checked;
    const Planes planes{&map.normal_x, &map.normal_y, &map.cone, &map.depth};
    for ([[maybe_unused]] const Image<float>* plane : planes)
        assert(plane->width() == map.grid.width && plane->height() == map.grid.height);

    EncodeRequest request = request_for(*map_format_of(path), map);
    request.threads = threads;
    Result<SharedMemory> file = [&]() -> Result<SharedMemory> {
        const auto pixels = SharedMemory::create(pixel_bytes(request));
        if (!pixels) return fail(ErrorCode::write_failed, path.string() + ": no memory to encode it in");
        interleave_as(map.info.bits, planes, pixels->bytes().data());
        return encode_image(request, *pixels, path.string());
    }();
    if (!file) return tl::unexpected(file.error());
    return write_file_atomically(path, file->bytes());
}

} // namespace reliefbake

#include "formats/map_file.h"

#include "formats/atomic_file.h"
#include "formats/encode_image.h"
#include "formats/map_format.h"
#include "formats/map_json.h"
#include "formats/map_layout.h"
#include "formats/map_pixels.h"

#include <cassert>
#include <cstdint>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

/// Where each format keeps a text that survives: PNG a tEXt chunk, EXR an attribute (and the important words one by one,
/// for people with exrheader), TIFF ImageDescription; TGA has 324 characters, too few.
nlohmann::json metadata_attributes(MapFormat format, const ReliefMap& map) {
    const nlohmann::json facts = to_json(map.info, map.grid);
    const std::string text = facts.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace); // ASCII: tEXt is Latin-1
    nlohmann::json attributes = nlohmann::json::object();
    if (format == MapFormat::png || format == MapFormat::openexr) attributes["reliefbake"] = text;
    if (format == MapFormat::tiff) attributes["ImageDescription"] = text;
    if (format == MapFormat::openexr)
        for (const char* key : {"kind", "family", "metric", "encoding", "surface", "normal_y", "guarantee"})
            attributes[std::string("reliefbake.") + key] = facts[key];
    return attributes;
}

EncodeRequest request_for(MapFormat format, const ReliefMap& map, const LayoutImage& image) {
    constexpr const char* writers[] = {"png", "tiff", "openexr", "targa"};
    constexpr const char* samples[] = {"uint8", "uint16", "half", "float"};
    EncodeRequest request;
    request.writer = writers[int(format)];
    request.width = image_width(map, image);
    request.height = map.grid.height;
    request.channels = image.channels;
    request.sample = samples[int(map.info.bits)];
    request.pixels = is_unorm(map.info.bits) ? request.sample : "float";
    request.attributes = metadata_attributes(format, map);
    return request;
}

Result<void> write_image_of(const fs::path& path, const ReliefMap& map, const LayoutImage& image, int threads) {
    EncodeRequest request = request_for(*map_format_of(path), map, image);
    request.threads = threads;
    Result<SharedMemory> file = [&]() -> Result<SharedMemory> {
        const auto pixels = SharedMemory::create(pixel_bytes(request));
        if (!pixels) return fail(ErrorCode::write_failed, path.string() + ": no memory to encode it in");
        interleave(map, image, is_unorm(map.info.bits) ? map.info.bits : BitDepth::float32, pixels->bytes().data());
        return encode_image(request, *pixels, path.string());
    }();
    if (!file) return tl::unexpected(file.error());
    return write_file_atomically(path, file->bytes());
}

} // namespace

Result<void> write_map(const fs::path& path, const ReliefMap& map, int threads) {
    if (Result<void> checked = check_map_format(path, map.info); !checked) return checked;
    assert(map.info.planes == int(map.cone_planes.size()));
    for (const LayoutImage& image : layout_images(map.info)) {
        for ([[maybe_unused]] const std::vector<int>& part : image.parts)
            for ([[maybe_unused]] const int plane : part)
                assert(plane_of(map, plane).width() == map.grid.width && plane_of(map, plane).height() == map.grid.height);
        const Result<void> written = write_image_of(image_path(path, image), map, image, threads);
        if (!written) return written;
    }
    return {};
}

} // namespace reliefbake

#include "formats/map_file.h"

#include "formats/atomic_file.h"
#include "formats/encode_image.h"
#include "formats/map_format.h"
#include "formats/map_json.h"
#include "formats/map_layout.h"
#include "formats/map_pixels.h"
#include "formats/texture_file.h"

#include <cassert>
#include <cstdint>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

using Levels = std::span<const ReliefMap>;

std::string metadata_text(const ReliefMap& map) {
    // ASCII: PNG's tEXt is Latin-1.
    return to_json(map.info, map.grid).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

EncodeRequest request_for(MapFormat format, Levels levels, const LayoutImage& image) {
    const ReliefMap& map = levels[0];
    EncodeRequest request;
    request.writer = writer_name(format);
    request.width = image_width(map, image);
    request.height = map.grid.height;
    request.channels = image.channels;
    request.sample = sample_name(map.info.bits);
    request.pixels = is_unorm(map.info.bits) ? request.sample : "float";
    request.attributes = map_attributes(format, to_json(map.info, map.grid));
    for (const ReliefMap& level : levels.subspan(1)) request.mips.emplace_back(image_width(level, image), level.grid.height);
    return request;
}

/// PNG, TIFF, EXR and TGA, by OpenImageIO in the helper.
Result<void> write_by_helper(const fs::path& path, Levels levels, const LayoutImage& image, int threads, FileBatch& batch) {
    EncodeRequest request = request_for(*map_format_of(path), levels, image);
    request.threads = threads;
    Result<SharedMemory> file = [&]() -> Result<SharedMemory> {
        const auto pixels = SharedMemory::create(pixel_bytes(request));
        if (!pixels) return fail(ErrorCode::write_failed, path.string() + ": no memory to encode it in");
        const BitDepth as = is_unorm(levels[0].info.bits) ? levels[0].info.bits : BitDepth::float32;
        std::byte* out = pixels->bytes().data();
        for (const ReliefMap& level : levels) {
            interleave(level, image, as, out);
            out += interleaved_bytes(level, image, as);
        }
        return encode_image(request, *pixels, path.string());
    }();
    if (!file) return tl::unexpected(file.error());
    return batch.add(path, file->bytes());
}

/// DDS and KTX2, by us.
Result<void> write_texture(const fs::path& path, Levels levels, const LayoutImage& image, FileBatch& batch) {
    const BitDepth bits = levels[0].info.bits;
    std::vector<std::vector<std::byte>> pixels;
    std::vector<TextureLevel> textures;
    for (const ReliefMap& level : levels) {
        pixels.emplace_back(interleaved_bytes(level, image, bits));
        interleave(level, image, bits, pixels.back().data());
        textures.push_back({image_width(level, image), level.grid.height, pixels.back()});
    }
    if (*map_format_of(path) == MapFormat::dds) return batch.add(path, encode_dds(bits, int(image.channels.size()), textures));
    return batch.add(path, encode_ktx2(bits, int(image.channels.size()), textures, metadata_text(levels[0]), "reliefbake " RELIEFBAKE_VERSION));
}

void assert_whole([[maybe_unused]] const ReliefMap& map, const LayoutImage& image) {
    for ([[maybe_unused]] const std::vector<int>& part : image.parts)
        for ([[maybe_unused]] const int plane : part)
            assert(plane_of(map, plane).width() == map.grid.width && plane_of(map, plane).height() == map.grid.height);
}

Result<void> write_in_one(const fs::path& path, Levels levels, int threads, FileBatch& batch) {
    const MapFormat format = *map_format_of(path);
    for (const LayoutImage& whole : layout_images(levels[0].info)) {
        const LayoutImage image = written_image(whole);
        for (const ReliefMap& level : levels) assert_whole(level, image);
        const fs::path file = image_path(path, image);
        const bool own = format == MapFormat::dds || format == MapFormat::ktx2;
        const Result<void> written = own ? write_texture(file, levels, image, batch) : write_by_helper(file, levels, image, threads, batch);
        if (!written) return written;
    }
    return {};
}

} // namespace

Result<void> write_map(const fs::path& path, const ReliefMap& map, FileBatch& batch, int threads) {
    if (Result<void> checked = check_map_format(path, map.info); !checked) return checked;
    assert(map.info.planes == int(map.cone_planes.size()));
    return write_in_one(path, std::span(&map, 1), threads, batch);
}

Result<void> write_map_levels(const fs::path& path, std::span<const ReliefMap> levels, FileBatch& batch, int threads) {
    if (levels[0].info.layout == ChannelLayout::side && levels.size() > 1)
        return fail(ErrorCode::usage, path.string() + ": mip levels cannot lie side by side; choose the layout pair or named");
    if (Result<void> checked = check_map_format(path, levels[0].info); !checked) return checked;
    if (holds_mips(path)) return write_in_one(path, levels, threads, batch);
    for (std::size_t n = 0; n < levels.size(); ++n)
        if (Result<void> written = write_map(mip_path(path, int(n)), levels[n], batch, threads); !written) return written;
    return {};
}

std::vector<fs::path> map_files(const fs::path& path, const ReliefMapInfo& info, bool mips) {
    constexpr int most_levels = 17; // 65536 x 65536 down to 1 x 1
    std::vector<fs::path> files;
    for (int level = 0; level < (mips && !holds_mips(path) ? most_levels : 1); ++level)
        for (const LayoutImage& image : layout_images(info)) files.push_back(image_path(mip_path(path, level), image));
    return files;
}

Result<void> write_map(const fs::path& path, const ReliefMap& map, int threads) {
    FileBatch batch;
    return write_map(path, map, batch, threads).and_then([&] { return batch.publish(); });
}

Result<void> write_map_levels(const fs::path& path, std::span<const ReliefMap> levels, int threads) {
    FileBatch batch;
    return write_map_levels(path, levels, batch, threads).and_then([&] { return batch.publish(); });
}

} // namespace reliefbake

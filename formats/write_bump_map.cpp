#include "formats/bump_file.h"

#include "formats/atomic_file.h"
#include "formats/encode_planes.h"
#include "formats/map_file.h"
#include "formats/map_format.h"

#include <cassert>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

std::vector<const Image<float>*> planes_of(const BumpMap& map, const BumpImage& image) {
    std::vector<const Image<float>*> planes;
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        const std::size_t plane = std::size_t(image.first) + c;
        planes.push_back(plane < map.planes.size() ? &map.planes[plane] : &map.depth);
    }
    return planes;
}

Result<void> add_image(FileBatch& batch, const fs::path& path, MapFormat format, const BumpMap& map, const BumpImage& image, int threads) {
    const auto planes = planes_of(map, image);
    const auto attributes = metadata_attributes(format, to_json(map.info, map.grid), {"kind"});
    const Result<SharedMemory> file = encode_planes(path, format, {image.channels, planes, map.info.bits, attributes}, threads);
    if (!file) return tl::unexpected(file.error());
    return batch.add(path, file->bytes());
}

} // namespace

Result<void> check_bump_format(const fs::path& path, const BumpMapInfo& info) {
    const Result<MapFormat> format = map_format_of(path);
    if (format == MapFormat::dds || format == MapFormat::ktx2)
        return fail(ErrorCode::usage, path.string() + ": bump maps are written as .png, .tif, .exr or .tga");
    const bool two_files = info.layout == ChannelLayout::pair, horizons = info.kind == BumpKind::horizon;
    if (info.layout == ChannelLayout::side || (info.layout != ChannelLayout::named && two_files != horizons))
        return fail(ErrorCode::usage, path.string() + ": horizons have the layout pair or named; derivatives and normals have rgba or named");
    return check_map_format(path, info.bits, info.layout);
}

Result<void> write_bump_map(const fs::path& path, const BumpMap& map, int threads) {
    if (Result<void> checked = check_bump_format(path, map.info); !checked) return checked;
    assert(int(map.planes.size()) == bump_planes(map.info.kind) && map.depth.empty() != holds_depth(map.info));
    FileBatch batch;
    for (const BumpImage& image : bump_images(map.info)) {
        const fs::path file = path.parent_path() / (path.stem().string() + image.suffix + path.extension().string());
        if (Result<void> added = add_image(batch, file, *map_format_of(path), map, image, threads); !added) return added;
    }
    return batch.publish();
}

} // namespace reliefbake

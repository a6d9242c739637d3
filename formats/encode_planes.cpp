#include "formats/encode_planes.h"

#include "formats/encode_image.h"
#include "formats/map_pixels.h"

namespace reliefbake {

Result<SharedMemory> encode_planes(const std::filesystem::path& path, MapFormat format, const PlanesImage& image, int threads) {
    const BitDepth as = is_unorm(image.bits) ? image.bits : BitDepth::float32;
    EncodeRequest request;
    request.writer = writer_name(format);
    request.width = image.planes[0]->width();
    request.height = image.planes[0]->height();
    request.channels = image.channels;
    request.sample = sample_name(image.bits);
    request.pixels = sample_name(as);
    request.threads = threads;
    request.attributes = image.attributes;
    const auto pixels = SharedMemory::create(pixel_bytes(request));
    if (!pixels) return fail(ErrorCode::write_failed, path.string() + ": no memory to encode it in");
    interleave(image.planes, as, pixels->bytes().data());
    return encode_image(request, *pixels, path.string());
}

} // namespace reliefbake

#include "formats/write_image.h"

#include "formats/atomic_file.h"
#include "formats/encode_image.h"

#include <cassert>
#include <cstring>

namespace reliefbake {

Result<void> write_png(const std::filesystem::path& path, int width, int height, int channels,
                       std::span<const std::uint8_t> samples) {
    assert(channels >= 1 && channels <= 4);
    assert(samples.size() == std::size_t(width) * std::size_t(height) * std::size_t(channels));
    const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};

    const auto pixels = SharedMemory::create(samples.size());
    if (!pixels) return fail(ErrorCode::write_failed, path.string() + ": no memory to encode it in");
    std::memcpy(pixels->bytes().data(), samples.data(), samples.size());
    const Result<SharedMemory> file =
        encode_image({"png", width, height, names[channels - 1], "uint8", "uint8"}, *pixels, path.string());
    if (!file) return tl::unexpected(file.error());
    return write_file_atomically(path, file->bytes());
}

} // namespace reliefbake

#include "formats/write_image.h"

#include "formats/atomic_file.h"
#include "formats/encode_image.h"

#include <cassert>
#include <cstring>

namespace reliefbake {

Result<std::string> encode_png(int width, int height, int channels, std::span<const std::uint8_t> samples, const std::string& name) {
    assert(channels >= 1 && channels <= 4);
    assert(samples.size() == std::size_t(width) * std::size_t(height) * std::size_t(channels));
    const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};

    const auto pixels = SharedMemory::create(samples.size());
    if (!pixels) return fail(ErrorCode::write_failed, name + ": no memory to encode it in");
    std::memcpy(pixels->bytes().data(), samples.data(), samples.size());
    const Result<SharedMemory> file = encode_image({"png", width, height, names[channels - 1], "uint8", "uint8"}, *pixels, name);
    if (!file) return tl::unexpected(file.error());
    const auto bytes = file->bytes();
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

Result<void> write_png(const std::filesystem::path& path, int width, int height, int channels, std::span<const std::uint8_t> samples) {
    const Result<std::string> file = encode_png(width, height, channels, samples, path.string());
    if (!file) return tl::unexpected(file.error());
    return write_file_atomically(path, *file);
}

} // namespace reliefbake

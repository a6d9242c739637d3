#include "formats/encode_image.h"

#include "formats/claims_json.h"
#include "formats/image_worker.h"

#include <cstdlib>
#include <ctime>

namespace reliefbake {

namespace {

/// SOURCE_DATE_EPOCH (reproducible-builds.org) or 1970, in UTC. PNG is left without a time: it needs none.
std::string fixed_time(const char* format) {
    std::time_t seconds = 0;
    if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
        char* end = nullptr;
        const long long value = std::strtoll(epoch, &end, 10);
        constexpr long long year_9999 = 253402300799;
        if (end != epoch && *end == '\0' && value >= 0 && value <= year_9999) seconds = std::time_t(value);
    }
    std::tm utc{};
    ::gmtime_r(&seconds, &utc);
    char text[32];
    std::strftime(text, sizeof text, format, &utc);
    return text;
}

/// Lossless, at the levels where half the time costs a few per cent of size: measurements in docs/FORMATS.md.
void add_compression(EncodeRequest& request) {
    nlohmann::json& attributes = request.attributes;
    if (request.writer == "openexr") attributes["compression"] = "zip:2";
    if (request.writer == "tiff") attributes["compression"] = "zip";
    if (request.writer == "tiff") attributes["tiff:zipquality"] = 4;
    if (request.writer == "png") attributes["png:compressionLevel"] = 4;
    if (request.writer == "targa") attributes["compression"] = "none";
}

void add_common_attributes(EncodeRequest& request) {
    nlohmann::json& attributes = request.attributes;
    attributes["Software"] = "reliefbake " RELIEFBAKE_VERSION;
    // Without it, channel 4 of our data would multiply the other three: the relief is destroyed where depth is near 0.
    if (request.writer == "png" || request.writer == "targa") attributes["oiio:UnassociatedAlpha"] = 1;
    if (request.writer != "png") attributes["DateTime"] = fixed_time("%Y:%m:%d %H:%M:%S");
    if (request.writer == "openexr") attributes["capDate"] = fixed_time("%Y:%m:%d %H:%M:%S");
    add_compression(request);
    if (request.writer == "tiff" && request.sample == "half") attributes["tiff:half"] = 1;
    // What makes OpenImageIO's readers take a TIFF's further directories for mip levels, and its EXR writer make some.
    if (!request.mips.empty()) attributes["textureformat"] = "Plain Texture";
}

int sample_size(const std::string& type) { return type == "uint8" ? 1 : type == "float" ? 4 : 2; }

} // namespace

std::uint64_t pixel_bytes(const EncodeRequest& request) {
    std::uint64_t pixels = std::uint64_t(request.width) * std::uint64_t(request.height);
    for (const auto& [width, height] : request.mips) pixels += std::uint64_t(width) * std::uint64_t(height);
    return pixels * request.channels.size() * std::uint64_t(sample_size(request.pixels));
}

nlohmann::json encode_message(const EncodeRequest& given) {
    EncodeRequest request = given;
    add_common_attributes(request);
    return {{"writer", request.writer},     {"width", request.width},   {"height", request.height},
            {"channels", request.channels}, {"sample", request.sample}, {"pixels", request.pixels},
            {"attributes", request.attributes}, {"mips", request.mips}, {"threads", request.threads}};
}

Result<SharedMemory> encode_image(const EncodeRequest& request, const SharedMemory& pixels, const std::string& name) {
    const std::uint64_t bytes = pixel_bytes(request);
    nlohmann::json message = encode_message(request);
    message["do"] = "encode", message["bytes"] = bytes;
    // The pixels, the library's converted copy, the encoded bytes twice, and room for doubling vectors. Deflate at 2 MiB
    // a second is the slowest that 16-bit noise gives.
    constexpr std::uint64_t scratch = 256ull << 20;
    constexpr std::uint64_t thread_memory = 160ull << 20; // address space: a stack, an allocator's arena, buffers
    const std::uint64_t memory = scratch + 8 * bytes + std::uint64_t(request.threads) * thread_memory;
    const ImageWorker::Limits limits{int(10 + bytes / (2u << 20)), memory};

    ImageWorker& worker = ImageWorker::instance();
    const auto lock = worker.lock();
    Result<Message> answer =
        worker.ask(message, pixels.fd(), limits, ImageWorker::Turn::first, ErrorCode::write_failed, name);
    if (!answer) return tl::unexpected(answer.error());
    auto file = SharedMemory::adopt(std::move(answer->fd), unsigned_member(answer->body, "bytes"));
    if (!file) return fail(ErrorCode::write_failed, name + ": the image helper's answer makes no sense");
    return std::move(*file);
}

} // namespace reliefbake

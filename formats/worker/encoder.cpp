#include "formats/worker/encoder.h"

#include "formats/unique_fd.h"
#include "formats/worker/decoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <new>
#include <utility>

namespace reliefbake::worker {

using nlohmann::json;

OIIO::ImageSpec spec_of(const json& request) {
    const auto channels = request.at("channels").get<std::vector<std::string>>();
    const OIIO::TypeDesc stored(request.at("sample").get<std::string>());
    OIIO::ImageSpec spec(request.at("width").get<int>(), request.at("height").get<int>(), int(channels.size()), stored);
    spec.channelnames = channels;
    const auto alpha = std::find(channels.begin(), channels.end(), "A");
    spec.alpha_channel = alpha == channels.end() ? -1 : int(alpha - channels.begin());
    for (const auto& [name, value] : request.at("attributes").items()) {
        if (value.is_string()) spec.attribute(name, value.get<std::string>());
        else spec.attribute(name, value.get<int>());
    }
    return spec;
}

namespace {

/// Level 0 and those of the request's mips.
std::vector<OIIO::ImageSpec> level_specs(const json& request) {
    std::vector<OIIO::ImageSpec> specs{spec_of(request)};
    for (const auto& [width, height] : request.at("mips").get<std::vector<std::pair<int, int>>>()) {
        specs.push_back(specs[0]);
        specs.back().width = specs.back().full_width = width;
        specs.back().height = specs.back().full_height = height;
    }
    constexpr int tile = 64; // a multiple of 16, as TIFF wants
    if (specs.size() > 1)
        for (OIIO::ImageSpec& spec : specs) spec.tile_width = spec.tile_height = tile;
    return specs;
}

std::size_t sample_count(const OIIO::ImageSpec& spec) { return spec.image_pixels() * std::size_t(spec.nchannels); }

bool write_levels(OIIO::ImageOutput& output, const std::string& file, const std::vector<OIIO::ImageSpec>& specs,
                  OIIO::TypeDesc given, const std::byte* pixels) {
    // A TIFF's levels are directories one behind another, as maketx writes them.
    const auto append = output.supports("mipmap") ? OIIO::ImageOutput::AppendMIPLevel : OIIO::ImageOutput::AppendSubimage;
    for (std::size_t n = 0; n < specs.size(); ++n) {
        if (!output.open(file, specs[n], n == 0 ? OIIO::ImageOutput::Create : append)) return false;
        if (!output.write_image(given, pixels)) return false;
        pixels += sample_count(specs[n]) * given.size();
    }
    return output.close();
}

/// A file in memory with a name that libraries can open.
class MemoryFile {
  public:
    MemoryFile() : fd_(::memfd_create("encoded", MFD_CLOEXEC)) {
        if (!fd_) throw std::bad_alloc();
    }
    std::string path() const { return "/proc/self/fd/" + std::to_string(fd_.get()); }
    std::vector<unsigned char> bytes() const {
        struct stat status {};
        if (::fstat(fd_.get(), &status) != 0) throw Refusal("cannot be encoded: no memory");
        std::vector<unsigned char> bytes(std::size_t(status.st_size));
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t size = ::pread(fd_.get(), bytes.data() + at, bytes.size() - at, off_t(at));
            if (size <= 0) throw Refusal("cannot be encoded: no memory");
            at += std::size_t(size);
        }
        return bytes;
    }

  private:
    UniqueFd fd_;
};

} // namespace

std::vector<unsigned char> encode(const json& request, std::span<const std::byte> pixels) {
    const std::vector<OIIO::ImageSpec> specs = level_specs(request);
    const OIIO::TypeDesc given(request.at("pixels").get<std::string>());
    std::size_t samples = 0;
    for (const OIIO::ImageSpec& spec : specs) samples += sample_count(spec);
    if (pixels.size() != samples * given.size()) throw Refusal("the pixels sent do not fit the size announced");

    const auto output = OIIO::ImageOutput::create(request.at("writer").get<std::string>());
    if (!output) throw Refusal("this build of OpenImageIO has no such writer");
    const bool whole = specs.size() == 1 || output->supports("mipmap");
    if (!whole && !output->supports("multiimage")) throw Refusal("this writer has no mip levels");
    use_exr_threads(request.at("threads").get<int>());

    // Judge by what the calls return: the TIFF writer leaves an error message after good files too.
    const auto refuse = [&]() { return Refusal("cannot be encoded: " + output->geterror()); };
    if (!whole) { // OpenImageIO 2.4 starts a TIFF in memory afresh with every directory, one in a file not
        const MemoryFile memory;
        if (!write_levels(*output, memory.path(), specs, given, pixels.data())) throw refuse();
        return memory.bytes();
    }
    std::vector<unsigned char> file;
    OIIO::Filesystem::IOVecOutput memory(file);
    output->set_ioproxy(&memory);
    if (!write_levels(*output, "memory", specs, given, pixels.data())) throw refuse();
    return file;
}

} // namespace reliefbake::worker

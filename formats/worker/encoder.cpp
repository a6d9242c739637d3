#include "formats/worker/encoder.h"

#include "formats/worker/decoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

namespace reliefbake::worker {

namespace {

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

} // namespace

std::vector<unsigned char> encode(const json& request, std::span<const std::byte> pixels) {
    const OIIO::ImageSpec wanted = spec_of(request);
    const OIIO::TypeDesc given(request.at("pixels").get<std::string>());
    if (pixels.size() != wanted.image_pixels() * std::size_t(wanted.nchannels) * given.size())
        throw Refusal("the pixels sent do not fit the size announced");

    const auto output = OIIO::ImageOutput::create(request.at("writer").get<std::string>());
    if (!output) throw Refusal("this build of OpenImageIO has no such writer");
    std::vector<unsigned char> file;
    OIIO::Filesystem::IOVecOutput memory(file);
    output->set_ioproxy(&memory);

    use_exr_threads(request.at("threads").get<int>());

    // Judge by what the calls return: the TIFF writer leaves an error message after good files too.
    const bool ok = output->open("memory", wanted) && output->write_image(given, pixels.data()) && output->close();
    if (!ok) throw Refusal("cannot be encoded: " + output->geterror());
    return file;
}

} // namespace reliefbake::worker

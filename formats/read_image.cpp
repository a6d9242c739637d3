#include "formats/read_image.h"

#include "formats/decode_session.h"
#include "formats/pixel_hash.h"

#include <algorithm>

namespace reliefbake {

namespace {

using Names = std::vector<std::string>;

/// One channel, or red, green and blue to be weighed.
struct Selection {
    std::vector<int> channels;
    std::string name;
};

int index_of(const Names& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : int(found - names.begin());
}

std::string list(const Names& names) {
    constexpr std::size_t most = 16;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i ? ", " : "") + names[i];
    if (names.size() > most) text += ", ... (" + std::to_string(names.size()) + " in all)";
    return text;
}

/// Luminance of a colour image; a grey image's Y is its luminance.
Result<Selection> select_luminance(const Names& names, const std::string& file) {
    const std::vector<int> colour{index_of(names, "R"), index_of(names, "G"), index_of(names, "B")};
    if (std::find(colour.begin(), colour.end(), -1) == colour.end()) return Selection{colour, "luminance"};
    if (const int grey = index_of(names, "Y"); grey >= 0) return Selection{{grey}, "Y"};
    return fail(ErrorCode::bad_data, file + ": has neither R, G and B nor Y; choose one of its channels with --channel: " +
                                         list(names));
}

Result<Selection> select(const Names& names, const std::string& wanted, const std::string& file) {
    if (wanted.empty() && names.size() == 1) return Selection{{0}, names[0]};
    if (const int exact = index_of(names, wanted); exact >= 0) return Selection{{exact}, wanted};
    if (wanted.empty() || wanted == "Y") return select_luminance(names, file);
    // Whether a grey file is stored as Y or as three equal channels is its writer's whim.
    const int grey = index_of(names, "Y");
    if (grey >= 0 && (wanted == "R" || wanted == "G" || wanted == "B")) return Selection{{grey}, "Y"};
    return fail(ErrorCode::bad_data, file + ": has no channel " + wanted + "; it has " + list(names));
}

/// Rec. 709 on the stored numbers. A grey pixel keeps its exact value: the weights sum to 1 only in real numbers.
float luminance(const float* rgb) {
    if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) return rgb[0];
    return float(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]);
}

/// `storage` may be null: the heap.
Result<SourceImage> read_through(Result<DecodeSession> session, const std::filesystem::path& path, const ReadOptions& options,
                                 std::pmr::memory_resource* storage) {
    // Look at the header.
    if (!session) return tl::unexpected(session.error());
    const ImageClaims& claims = session->claims();
    const bool take_alpha = options.prefer_alpha && options.channel.empty() && index_of(claims.channels, "A") >= 0;
    const Result<Selection> selection = select(claims.channels, take_alpha ? "A" : options.channel, path.string());
    if (!selection) return tl::unexpected(selection.error());

    SourceImage image;
    image.format = reader_name(session->format());
    image.channel_names = claims.channels;
    image.channel = selection->name;
    image.is_integer = is_integer(claims.sample);
    image.bit_depth = claims.bit_depth;
    image.srgb_tagged = claims.srgb_tagged;
    image.no_data = session->no_data();

    // Take the rows.
    image.plane = storage ? Image<float>::unfilled(int(claims.width), int(claims.height), storage)
                          : Image<float>(int(claims.width), int(claims.height));
    const std::size_t stride = selection->channels.size();
    const Result<void> done = session->read(selection->channels, [&](int y, int rows, const float* samples) {
        float* out = image.plane.row(y);
        const std::size_t count = std::size_t(rows) * std::size_t(claims.width);
        if (stride == 1) std::copy(samples, samples + count, out);
        else
            for (std::size_t i = 0; i < count; ++i) out[i] = luminance(samples + i * stride);
    });
    if (!done) return tl::unexpected(done.error());
    image.pixel_hash = pixel_hash(image.plane);
    return image;
}

} // namespace

Result<SourceImage> read_image(const std::filesystem::path& path, const ReadOptions& options) {
    return read_through(DecodeSession::open(path, options.max_bytes, 1), path, options, nullptr);
}

Result<SourceImage> read_image_into(std::pmr::memory_resource& storage, const std::filesystem::path& path, const ReadOptions& options) {
    return read_through(DecodeSession::open_rows(path, options.max_bytes), path, options, &storage);
}

Result<ImageSides> look_at_sides(const std::filesystem::path& path, const ReadOptions& options) {
    return DecodeSession::open_rows(path, options.max_bytes).map([](const DecodeSession& session) {
        return ImageSides{int(session.claims().width), int(session.claims().height)};
    });
}

} // namespace reliefbake

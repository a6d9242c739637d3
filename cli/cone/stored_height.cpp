#include "cli/cone/stored_height.h"

#include <cassert>
#include <cmath>
#include <string>
#include <utility>

namespace reliefbake {

namespace {

/// A no-data value is given in the file's own numbers; the plane of an integer file is scaled to 0..1.
Result<HeightOptions> with_no_data(HeightOptions options, const SourceImage& source, const std::string& name) {
    const double largest = std::ldexp(1.0, source.bit_depth) - 1;
    const bool given = options.no_data.has_value();
    if (!given) options.no_data = source.no_data;
    if (!options.no_data || !source.is_integer) return options;
    const double code = *options.no_data;
    if (given && (code < 0 || code > largest || code != std::floor(code)))
        return fail(ErrorCode::usage, "--no-data: " + name + " holds whole numbers from 0 to " + std::to_string(long(largest)));
    options.no_data = float(code / largest);
    return options;
}

/// What follows the decoding.
Result<BakeSource> check_source(Result<SourceImage> image, const ConeCommandOptions& given, StageClock& clock) {
    if (!image) return tl::unexpected(image.error());
    const Result<HeightOptions> options = with_no_data(given.height, *image, given.input);
    if (!options) return tl::unexpected(options.error());
    Alpha alpha;
    if (!given.alpha.from.empty()) {
        Result<Alpha> read = clock.time("alpha", [&] { return read_alpha(given.alpha, given.input, *image, given.read.max_bytes); });
        if (!read) return tl::unexpected(read.error());
        alpha = std::move(*read);
    }
    Result<CheckedHeight> height = clock.time("height", [&] {
        return make_height_field(std::move(image->plane), image->is_integer, *options, given.input, std::move(alpha.holes));
    });
    if (!height) return tl::unexpected(height.error());
    image->plane = {};
    return BakeSource{std::move(*image), std::move(alpha.pixel_hash), height->report, std::move(height->field)};
}

} // namespace

Result<BakeSource> read_source(const ConeCommandOptions& given, StageClock& clock) {
    return check_source(clock.time("read", [&] { return read_image(given.input, given.read); }), given, clock);
}

Result<BakeSource> read_source_into(std::pmr::memory_resource& storage, const ConeCommandOptions& given, StageClock& clock) {
    assert(given.alpha.from.empty());
    return check_source(clock.time("read", [&] { return read_image_into(storage, given.input, given.read); }), given, clock);
}

Result<StoredHeight> read_stored_height(const ConeCommandOptions& given, BitDepth bits, StageClock& clock) {
    Result<BakeSource> source = read_source(given, clock);
    if (!source) return tl::unexpected(source.error());
    DepthMap depth = clock.time("quantise", [&] { return quantise_depth(*source->field, bits); });
    return StoredHeight{std::move(source->image), source->report, std::move(depth)};
}

} // namespace reliefbake

#include "cli/options/alpha_options.h"

#include "cli/options/number_options.h"

#include <algorithm>
#include <filesystem>

namespace reliefbake {

namespace {

constexpr NumberRule positive_fraction = {[](double x) { return x > 0 && x <= 1; }, "a number greater than 0 and up to 1"};

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string size_of(const Image<float>& plane) { return std::to_string(plane.width()) + " x " + std::to_string(plane.height()); }

Result<SourceImage> read_alpha_file(const std::string& file, std::uint64_t max_bytes) {
    ReadOptions read;
    read.max_bytes = max_bytes;
    read.prefer_alpha = true;
    return read_image(file, read);
}

} // namespace

void add_alpha_options(CLI::App& app, AlphaOptions& options) {
    app.option_defaults()->group("Source");
    CLI::Option* alpha = app.add_option("--alpha", options.from,
                                        "Holes through which rays fall: a channel of IN (A), or an image of its size (its only channel, "
                                        "else A, else luminance)")
                             ->type_name("FILE|CHANNEL");
    add_number(app, "--alpha-threshold", options.threshold, positive_fraction, "Texels whose alpha is below it are holes (default 0.5)")
        ->needs(alpha);
}

Result<Alpha> read_alpha(const AlphaOptions& options, const std::string& input, const SourceImage& source, std::uint64_t max_bytes) {
    const bool is_channel = has(source.channel_names, options.from);
    std::error_code ignored;
    if (!is_channel && !std::filesystem::exists(options.from, ignored)) {
        std::string channels;
        for (const std::string& name : source.channel_names) channels += (channels.empty() ? "" : ", ") + name;
        return fail(ErrorCode::no_input, "--alpha " + options.from + ": " + input + " has no such channel (it has " + channels +
                                             "), and there is no such file");
    }
    const Result<SourceImage> image = is_channel ? read_image(input, {options.from, max_bytes}) : read_alpha_file(options.from, max_bytes);
    if (!image) return tl::unexpected(image.error());
    const Image<float>& heights = source.plane;
    if (image->plane.width() != heights.width() || image->plane.height() != heights.height())
        return fail(ErrorCode::bad_data, options.from + ": expected the size of " + input + ", " + size_of(heights) + ", found " +
                                             size_of(image->plane) + "; resample one of them");
    Result<HoleMask> holes = find_holes(image->plane, options.threshold, is_channel ? input : options.from);
    if (!holes) return tl::unexpected(holes.error());
    return Alpha{std::move(*holes), image->pixel_hash};
}

} // namespace reliefbake

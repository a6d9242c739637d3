#include "cli/options/number_options.h"

#include "bake/texel_grid.h"

#include <charconv>
#include <cmath>

namespace reliefbake {

const NumberRule finite_number = {[](double x) { return std::isfinite(x); }, "a number"};
const NumberRule positive_number = {[](double x) { return std::isfinite(x) && x > 0; },
                                    "a number greater than 0"};
const NumberRule positive_or_inf = {[](double x) { return x > 0; }, "a number greater than 0, or inf"};
const NumberRule fraction_number = {[](double x) { return x >= 0 && x <= 1; }, "a number from 0 to 1"};
const NumberRule pixel_aspect = {is_baked_pixel_aspect,
                                 "a number from 0.5 to 2 (resample the image to squarer texels)"};

std::optional<double> parse_number(const std::string& text) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || rest != end) return std::nullopt;
    return number;
}

double require_number(const std::string& flag, const std::string& text, const NumberRule& rule) {
    const std::optional<double> number = parse_number(text);
    if (number && rule.holds(*number)) return *number;
    throw CLI::ValidationError(flag, std::string("expected ") + rule.expected + ", found '" + text + "'");
}

std::pair<int, int> require_size(const std::string& flag, const std::string& text) {
    constexpr int most_pixels = 16384; // a side
    const char* end = text.data() + text.size();
    std::pair<int, int> size;
    const auto width = std::from_chars(text.data(), end, size.first);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.second);
        const auto fits = [](int side) { return side >= 1 && side <= most_pixels; };
        if (height.ec == std::errc() && height.ptr == end && fits(size.first) && fits(size.second)) return size;
    }
    throw CLI::ValidationError(flag, "expected WIDTHxHEIGHT, such as 1024x768, found '" + text + "'");
}

std::pair<double, double> require_repeats(const std::string& flag, const std::string& text) {
    static const NumberRule repeats_number = {[](double x) { return x > 0 && x <= 1e4; }, "a number above 0, up to 1e4"};
    const std::size_t comma = text.find(',');
    const double along_u = require_number(flag, text.substr(0, comma), repeats_number);
    return {along_u, comma == text.npos ? along_u : require_number(flag, text.substr(comma + 1), repeats_number)};
}

void add_byte_budget(CLI::App& app, std::uint64_t& bytes) {
    app.add_option("--max-bytes", bytes,
                   "Budget for the decoded image, e.g. 4GB (default, or 0: 1 GiB, and 1000 times the file's "
                   "size above 64 MiB)")
        ->transform(CLI::AsSizeValue(false))
        ->type_name("BYTES");
}

} // namespace reliefbake

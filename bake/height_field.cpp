#include "bake/height_field.h"

#include "bake/bad_texels.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace reliefbake {

namespace {

/// Source values that become height 0 and 1; equal for a flat source.
struct SourceRange {
    double low = 0, high = 1;
    bool from_data = false;
};

std::string number_text(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, float(value)).ptr};
}

std::string position_text(int x, int y) {
    return std::string("(").append(std::to_string(x)).append(", ").append(std::to_string(y)).append(")");
}

Result<void> validate_options(const HeightOptions& options, bool source_is_integer, const std::string& name) {
    if (source_is_integer && options.range == RangeMode::fixed && (options.range_low < 0 || options.range_high > 1))
        return fail(ErrorCode::usage, name + ": range: integer samples run from 0 to 1 (code / largest code), found " +
                                          number_text(options.range_low) + ":" + number_text(options.range_high));
    if (options.range == RangeMode::fixed && !(options.range_low < options.range_high))
        return fail(ErrorCode::usage, name + ": range: expected a low value below the high one, found " +
                                          number_text(options.range_low) + ":" +
                                          number_text(options.range_high));
    if (!std::isfinite(options.range_low) || !std::isfinite(options.range_high))
        return fail(ErrorCode::usage, name + ": range: expected finite values");
    if (!std::isfinite(options.scale) || !std::isfinite(options.bias))
        return fail(ErrorCode::usage, name + ": scale and bias: expected finite values");
    if (!is_baked_pixel_aspect(options.pixel_aspect))
        return fail(ErrorCode::usage, name + ": pixel aspect: expected a value from 0.5 to 2, found " +
                                          number_text(options.pixel_aspect) +
                                          "; resample the image to squarer texels");
    return {};
}

/// Every texel of the result is finite. Holes hold what lies beside them, so that they change no range.
Result<Image<float>> validate_samples(Image<float> source, const HoleMask& holes, const HeightOptions& options,
                                      const std::string& name, HeightReport& report) {
    BadTexels bad = find_bad_texels(source, options.no_data, holes);
    report.bad_texels = bad.count;
    const std::size_t open = std::size_t(std::count(holes.begin(), holes.end(), 1));
    if (bad.count > 0 && bad.count + open == source.size())
        return fail(ErrorCode::bad_data, name + ": expected heights, found only NaN, Inf or no-data values");
    if (bad.count > 0 && options.nan == NanPolicy::error)
        return fail(ErrorCode::bad_data, name + ": expected a height everywhere, found " +
                                             std::to_string(bad.count) +
                                             " NaN, Inf or no-data values, the first at " +
                                             position_text(bad.first_x, bad.first_y) +
                                             "; --nan fill fills them from the nearest valid texel");
    if (open == source.size()) return Image<float>(source.width(), source.height(), options.range == RangeMode::fixed ? options.range_low : 0);
    add_holes(holes, bad);
    fill_bad_texels(source, std::move(bad));
    return source;
}

SourceRange choose_range(const HeightOptions& options, bool source_is_integer, const HeightReport& report) {
    if (options.range == RangeMode::fixed) return {options.range_low, options.range_high, false};
    const bool fits = report.source_low >= 0 && report.source_high <= 1;
    if (options.range == RangeMode::automatic && (source_is_integer || fits)) return {};
    return {report.source_low, report.source_high, true};
}

Result<void> validate_range(const Image<float>& plane, const SourceRange& range, const std::string& name) {
    const auto outside = [&](float v) { return v < range.low || v > range.high; };
    const auto first = std::find_if(plane.begin(), plane.end(), outside);
    if (first == plane.end()) return {};
    const std::size_t at = std::size_t(first - plane.begin()), width = std::size_t(plane.width());
    return fail(ErrorCode::bad_data, name + ": expected values in " + number_text(range.low) + ":" +
                                         number_text(range.high) + ", found " +
                                         std::to_string(std::count_if(first, plane.end(), outside)) +
                                         " outside, the first " + number_text(*first) + " at " +
                                         position_text(int(at % width), int(at / width)) +
                                         "; --range data takes the smallest and largest value");
}

/// height = scale * h + bias is monotone in h: its ends tell whether it leaves 0..1.
Result<void> validate_scale(const HeightOptions& options, double low, double high, const std::string& name) {
    const double a = options.scale * low + options.bias, b = options.scale * high + options.bias;
    if (std::min(a, b) >= 0 && std::max(a, b) <= 1) return {};
    return fail(ErrorCode::bad_data, name + ": expected heights in 0..1 after scale and bias, found " +
                                         number_text(std::min(a, b)) + ".." + number_text(std::max(a, b)));
}

/// Source value to height; monotone, so that the extremes of the source give the extremes of the heights.
class HeightMapping {
  public:
    HeightMapping(const HeightOptions& options, const SourceRange& range)
        : options_(options), range_(range), flat_(range.low == range.high) {}

    double unscaled(double value) const {
        const double unit = flat_ ? 1 : (value - range_.low) / (range_.high - range_.low);
        return options_.input == InputKind::depth && !flat_ ? 1 - unit : unit;
    }
    float operator()(float value) const { return float(options_.scale * unscaled(value) + options_.bias); }

  private:
    const HeightOptions& options_;
    SourceRange range_;
    bool flat_;
};

Wrap resolve_wrap(WrapChoice choice, const Seam& seam) {
    if (choice == WrapChoice::automatic) return wrap_for_seam(seam);
    return choice == WrapChoice::repeat ? Wrap::repeat : Wrap::clamp;
}

} // namespace

/// The one maker of height fields.
class HeightFieldBuilder {
  public:
    static HeightField build(Image<float> heights, HoleMask holes, const HeightOptions& options, const HeightReport& report) {
        TexelGrid grid;
        grid.width = heights.width();
        grid.height = heights.height();
        grid.wrap_x = resolve_wrap(options.wrap_x, report.seam_x);
        grid.wrap_y = resolve_wrap(options.wrap_y, report.seam_y);
        grid.pixel_aspect = options.pixel_aspect;
        return HeightField(grid, std::move(heights), std::move(holes));
    }
};

Result<CheckedHeight> make_height_field(Image<float> source, bool source_is_integer, const HeightOptions& options,
                                        const std::string& name, HoleMask holes) {
    assert(holes.empty() || (holes.width() == source.width() && holes.height() == source.height()));
    if (Result<void> valid = validate_options(options, source_is_integer, name); !valid) return tl::unexpected(valid.error());
    // Make every sample finite.
    HeightReport report;
    Result<Image<float>> plane = validate_samples(std::move(source), holes, options, name, report);
    if (!plane) return tl::unexpected(plane.error());
    const auto [low, high] = std::minmax_element(plane->begin(), plane->end());
    report.source_low = *low;
    report.source_high = *high;
    // Choose what becomes 0 and 1, and refuse what would leave that range.
    const SourceRange range = choose_range(options, source_is_integer, report);
    report.range_low = range.low;
    report.range_high = range.high;
    report.range_from_data = range.from_data;
    const HeightMapping mapping(options, range);
    const Result<void> valid = validate_range(*plane, range, name).and_then([&] {
        return validate_scale(options, mapping.unscaled(report.source_low),
                              mapping.unscaled(report.source_high), name);
    });
    if (!valid) return tl::unexpected(valid.error());
    // Map to heights, and measure whether they tile.
    for (float& value : *plane)
        value = mapping(value);
    for (std::size_t k = 0; k < holes.size(); ++k)
        if (holes[k]) (*plane)[k] = 0;
    const Seams seams = measure_seams(*plane);
    report.seam_x = seams.x;
    report.seam_y = seams.y;
    return CheckedHeight{HeightFieldBuilder::build(std::move(*plane), std::move(holes), options, report), report};
}

} // namespace reliefbake

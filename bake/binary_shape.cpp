#include "bake/binary_shape.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

namespace reliefbake {

namespace {

Result<void> check_options(const ShapeOptions& options, const std::string& name) {
    if (!(options.threshold >= 0 && options.threshold <= 1))
        return fail(ErrorCode::usage, name + ": threshold: expected a sample value from 0 to 1");
    if (options.model == ShapeModel::contour && options.threshold != 0.5)
        return fail(ErrorCode::usage, name + ": threshold: an anti-aliased edge lies where half of a texel is covered; drop the threshold");
    return {};
}

Result<void> check_samples(const Image<float>& samples, bool in_unit, const std::string& name) {
    std::size_t bad = 0, first = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const float v = samples[k];
        if (in_unit ? v >= 0 && v <= 1 : !std::isnan(v)) continue;
        if (bad++ == 0) first = k;
    }
    if (bad == 0) return {};
    const std::size_t width = std::size_t(samples.width());
    return fail(ErrorCode::bad_data, name + ": expected " + (in_unit ? "samples in 0..1" : "numbers") + ", found " + std::to_string(bad) +
                                         (in_unit ? " outside" : " NaN") + ", the first at (" + std::to_string(first % width) + ", " +
                                         std::to_string(first / width) + ")");
}

} // namespace

Result<BinaryShape> make_shape(Image<float> samples, const ShapeOptions& options, const std::string& name) {
    const bool contour = options.model == ShapeModel::contour;
    Result<void> checked = check_options(options, name).and_then([&] { return check_samples(samples, contour, name); });
    if (!checked) return tl::unexpected(checked.error());

    BinaryShape shape;
    shape.model_ = options.model;
    shape.grid_ = {samples.width(), samples.height(), options.wrap_x ? Wrap::repeat : Wrap::clamp,
                   options.wrap_y ? Wrap::repeat : Wrap::clamp, 1};
    shape.outside_ = Image<std::uint8_t>(samples.width(), samples.height());
    const bool bright_inside = options.bright_is_inside != options.invert;
    if (contour) {
        if (!bright_inside)
            for (float& v : samples) v = 1 - v;
        for (std::size_t k = 0; k < samples.size(); ++k) shape.outside_[k] = samples[k] < 0.5f;
        shape.coverage_ = std::move(samples);
    } else {
        const double threshold = options.threshold;
        for (std::size_t k = 0; k < samples.size(); ++k) shape.outside_[k] = (double(samples[k]) >= threshold) != bright_inside;
    }
    std::uint64_t outside = 0;
    for (const std::uint8_t v : shape.outside_) outside += v;
    shape.inside_count_ = shape.outside_.size() - outside;
    shape.empty_ = shape.inside_count_ == 0, shape.full_ = outside == 0;
    for (const float part : shape.coverage_) shape.empty_ = shape.empty_ && part == 0, shape.full_ = shape.full_ && part == 1;
    return shape;
}

} // namespace reliefbake

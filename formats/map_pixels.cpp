#include "formats/map_pixels.h"

#include <Imath/half.h>

#include <cassert>
#include <cstring>
#include <type_traits>

namespace reliefbake {

namespace {

template <class Sample>
Sample sample_of(float value, float scale) {
    if constexpr (std::is_integral_v<Sample>) {
        assert(value >= 0 && value <= 1);
        return Sample(value * scale + 0.5f); // value is code / max_code up to rounding
    } else {
        return Sample(value);
    }
}

/// A plane into every `step`-th sample, its rows `stride` samples apart.
template <class Sample>
void spread(const Image<float>& plane, float scale, std::size_t step, std::size_t stride, Sample* out) {
    for (int y = 0; y < plane.height(); ++y) {
        const float* row = plane.row(y);
        Sample* to = out + std::size_t(y) * stride;
        for (std::size_t x = 0; x < std::size_t(plane.width()); ++x) to[x * step] = sample_of<Sample>(row[x], scale);
    }
}

template <class Sample>
void interleave_as(const ReliefMap& map, const LayoutImage& image, float scale, Sample* out) {
    const std::size_t width = std::size_t(map.grid.width), channels = image.channels.size();
    const std::size_t stride = channels * width * image.parts.size();
    for (std::size_t part = 0; part < image.parts.size(); ++part)
        for (std::size_t c = 0; c < channels; ++c)
            spread(plane_of(map, image.parts[part][c]), scale, channels, stride, out + part * channels * width + c);
}

template <class Sample>
void interleave_as(std::span<const Image<float>* const> planes, float scale, Sample* out) {
    const std::size_t channels = planes.size(), stride = channels * std::size_t(planes[0]->width());
    for (std::size_t c = 0; c < channels; ++c) spread(*planes[c], scale, channels, stride, out + c);
}

/// Calls work(scale, samples) with `out` as samples of the type that `as` stands for.
template <class Work>
void with_samples(BitDepth as, std::byte* out, const Work& work) {
    static_assert(sizeof(Imath::half) == 2);
    const float scale = float(max_code(as));
    switch (as) {
    case BitDepth::unorm8: return work(scale, reinterpret_cast<std::uint8_t*>(out));
    case BitDepth::unorm16: return work(scale, reinterpret_cast<std::uint16_t*>(out));
    case BitDepth::half: return work(scale, reinterpret_cast<Imath::half*>(out));
    case BitDepth::float32: return work(scale, reinterpret_cast<float*>(out));
    }
}

} // namespace

int sample_bytes_of(BitDepth bits) { return bits == BitDepth::unorm8 ? 1 : bits == BitDepth::float32 ? 4 : 2; }

std::uint64_t interleaved_bytes(const ReliefMap& map, const LayoutImage& image, BitDepth as) {
    return std::uint64_t(image_width(map, image)) * std::uint64_t(map.grid.height) * image.channels.size() *
           std::uint64_t(sample_bytes_of(as));
}

void interleave(const ReliefMap& map, const LayoutImage& image, BitDepth as, std::byte* out) {
    with_samples(as, out, [&](float scale, auto* samples) { interleave_as(map, image, scale, samples); });
}

void interleave(std::span<const Image<float>* const> planes, BitDepth as, std::byte* out) {
    with_samples(as, out, [&](float scale, auto* samples) { interleave_as(planes, scale, samples); });
}

} // namespace reliefbake

#include "cli/stress/stress_fields.h"

#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace reliefbake {
namespace {

constexpr double turn = 6.283185307179586;

double hills(int x, int y, double) { return 0.5 + 0.25 * std::sin(turn * x / 13) * std::cos(turn * y / 11) + 0.25 * std::sin(turn * (x + y) / 29); }

double white(int x, int y, double) { return stress_noise(x, y); }

/// Heights 1/2 and one quantum less; a depth of 1/2 and more has codes that far apart in every format.
double plateaus(int x, int y, double quantum) { return quantum * (std::floor(0.5 / quantum) - (x / 4 + y / 4) % 2); }

/// A field of numbers: what the heights are, not how many.
StressField numbers(std::string name, int side, std::function<double(int, int, double)> value, RangeMode range = RangeMode::automatic) {
    return {std::move(name), side, side, std::move(value), range};
}

std::vector<StressField> fields_of_numbers(int side) {
    const auto offset = [](double high, double detail) { return [high, detail](int x, int y, double) { return high + detail * stress_noise(x, y); }; };
    const auto denormals = [](int x, int y, double) { return double(std::numeric_limits<float>::denorm_min()) * std::floor(8 * stress_noise(x, y)); };
    const auto wall = [](int x, int, double) { return x % 8 == 3 ? 1.0 : 0.0; };
    const auto spike = [side](int x, int y, double) { return x == side / 2 && y == side / 2 ? 1.0 : 0.0; };
    return {
        numbers("constant", side, [](int, int, double) { return 0.5; }),
        numbers("offset-1e6-detail-1e-3", side, offset(1e6, 1e-3), RangeMode::data),
        numbers("offset-1e6-detail-1", side, offset(1e6, 1), RangeMode::data),
        numbers("detail-1e-3", side, offset(0.5, 1e-3)),
        numbers("denormals", side, denormals),
        numbers("denormals-stretched", side, denormals, RangeMode::data),
        numbers("depths-of-2^-24", side, [](int x, int y, double) { return stress_noise(x, y) < 0.5 ? 1.0 : 1 - 0x1p-24; }), // the smallest half
        numbers("plateaus", side, plateaus),
        numbers("walls", side, wall),
        numbers("spike", side, spike),
        numbers("ramp-with-cliff", side, [side](int x, int, double) { return double(x) / side; }),
        numbers("white-noise", side, white),
        numbers("checkerboard", side, [](int x, int y, double) { return (x + y) % 2; }),
        numbers("hills", side, hills),
    };
}

std::vector<StressField> fields_of_proportions(int side) {
    std::vector<StressField> fields;
    for (const auto& [word, scale] : {std::pair("1e-4", 1e-4), std::pair("1e-2", 1e-2), std::pair("10", 10.0), std::pair("1e4", 1e4)})
        for (const bool rough : {false, true}) {
            StressField field = numbers(std::string("depth-scale-") + word + (rough ? "-white-noise" : "-hills"), side, rough ? white : hills);
            field.depth_scale = scale;
            field.exact = false; // cones do not depend on it
            fields.push_back(std::move(field));
        }
    for (const auto& [word, aspect] : {std::pair("0.5", least_pixel_aspect), std::pair("2", largest_pixel_aspect)}) {
        StressField field = numbers(std::string("pixel-aspect-") + word, side, white);
        field.pixel_aspect = aspect;
        fields.push_back(std::move(field));
    }
    return fields;
}

std::vector<StressField> fields_of_sizes(StressExtent extent) {
    constexpr std::pair<int, int> small[] = {{1, 1}, {2, 1}, {1, 3}, {7, 5}, {1024, 1}, {1, 1024}, {1024, 16}, {16, 1024}};
    constexpr std::pair<int, int> large[] = {{16384, 1}, {1, 16384}, {16384, 256}, {256, 16384}, {2048, 2048}};
    constexpr std::pair<int, int> largest[] = {{16384, 16384}};
    std::vector<StressField> fields;
    const auto add = [&](const auto& sizes, bool march) {
        for (const auto& [width, height] : sizes) {
            fields.push_back({"size-" + std::to_string(width) + "x" + std::to_string(height), width, height, white});
            fields.back().march = fields.back().exact = march;
        }
    };
    add(small, true);
    if (extent != StressExtent::quick) add(large, true);
    if (extent == StressExtent::full) add(largest, false);
    return fields;
}

} // namespace

double quantum_of(BitDepth bits) {
    switch (bits) {
    case BitDepth::unorm8: return 1.0 / 255;
    case BitDepth::unorm16: return 1.0 / 65535;
    case BitDepth::half: return 0x1p-11;
    case BitDepth::float32: return 0x1p-24;
    }
    return 0;
}

double stress_noise(int x, int y) {
    std::uint64_t z = (std::uint64_t(std::uint32_t(x)) << 32 | std::uint32_t(y)) + 0x9e3779b97f4a7c15u; // SplitMix64
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

std::vector<StressField> stress_fields(StressExtent extent) {
    const int side = extent == StressExtent::quick ? 16 : 32;
    std::vector<StressField> fields = fields_of_numbers(side);
    for (auto more : {fields_of_proportions(side), fields_of_sizes(extent)}) std::move(more.begin(), more.end(), std::back_inserter(fields));
    return fields;
}

} // namespace reliefbake

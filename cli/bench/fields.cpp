#include "cli/bench/fields.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace reliefbake {

namespace {

/// The finaliser of SplitMix64: the same noise on every platform.
double hash01(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return double((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

/// Tiling value noise with `cells` cells per side.
double value_noise(double u, double v, int cells) {
    const double x = u * cells, y = v * cells;
    const int i = int(x), j = int(y);
    const auto at = [&](int a, int b) {
        return hash01(std::uint64_t(cells) << 40 | std::uint64_t(b % cells) << 20 | std::uint64_t(a % cells));
    };
    const double fx = (x - i) * (x - i) * (3 - 2 * (x - i)), fy = (y - j) * (y - j) * (3 - 2 * (y - j));
    return (1 - fy) * ((1 - fx) * at(i, j) + fx * at(i + 1, j)) + fy * ((1 - fx) * at(i, j + 1) + fx * at(i + 1, j + 1));
}

double fbm(double u, double v, int size) {
    double sum = 0, weight = 0, amplitude = 1;
    for (int cells = 4; cells <= size / 2; cells *= 2, amplitude *= 0.5) {
        sum += amplitude * value_noise(u, v, cells);
        weight += amplitude;
    }
    return weight > 0 ? sum / weight : 0.5;
}

double height(const std::string& name, int i, int j, int size) {
    const double u = TexelGrid::centre(i, size), v = TexelGrid::centre(j, size);
    if (name == "ramp") return u;
    if (name == "pyramid") return 1 - 2 * std::max(std::fabs(u - 0.5), std::fabs(v - 0.5));
    if (name == "hill") return std::max(0.0, 1 - 2 * std::sqrt((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)));
    if (name == "saw-tooth") return u * 8 - std::floor(u * 8);
    if (name == "stairs") return std::floor(u * 32) / 32;
    if (name == "checkerboard") return (i / 8 + j / 8) % 2;
    if (name == "spike") return i == size / 2 && j == size / 3 ? 1 : 0;
    if (name == "noise") return hash01(std::uint64_t(j) << 32 | std::uint64_t(i));
    if (name == "fbm") return fbm(u, v, size);
    return 0.5;
}

} // namespace

const std::vector<std::string>& field_names() {
    static const std::vector<std::string> names = {"ramp",         "pyramid", "hill",  "saw-tooth", "stairs",
                                                   "checkerboard", "spike",   "noise", "constant",  "fbm"};
    return names;
}

DepthMap make_field(const std::string& name, int size) {
    DepthMap depth{{size, size, Wrap::repeat, Wrap::repeat, 1}, BitDepth::unorm16, Image<float>(size, size)};
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i)
            depth.level(i, j) = float(std::floor((1 - height(name, i, j, size)) * 65535 + 0.5));
    return depth;
}

} // namespace reliefbake

#include "cli/bench/terrain.h"

#include <algorithm>

namespace reliefbake {

namespace {

constexpr int least_pitch = 4, most_octaves = 14;

/// 0 to 1, by the place alone (the finaliser of MurmurHash3).
float lattice_value(std::uint32_t x, std::uint32_t y, std::uint32_t salt) {
    std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ salt * 0xc2b2ae3du;
    h ^= h >> 16, h *= 0x85ebca6bu, h ^= h >> 13, h *= 0xc2b2ae35u, h ^= h >> 16;
    return float(h >> 8) * 0x1p-24f;
}

} // namespace

Terrain::Terrain(int width, std::uint32_t seed) : width_(width), seed_(seed) {
    float amplitude = 0.5f;
    for (int pitch = std::max(width / 4, least_pitch); pitch >= least_pitch && int(octaves_.size()) < most_octaves; pitch /= 2, amplitude *= 0.5f) {
        Octave octave{pitch, amplitude, {}};
        for (int i = 0; i < pitch; ++i) {
            const float t = float(i) / float(pitch);
            octave.weight.push_back(t * t * (3 - 2 * t));
        }
        octaves_.push_back(std::move(octave));
    }
}

void Terrain::row(int y, std::uint16_t* out) const {
    std::vector<float> height(std::size_t(width_), 0.0f), lattice;
    for (std::size_t k = 0; k < octaves_.size(); ++k) {
        const Octave& octave = octaves_[k];
        const std::uint32_t salt = seed_ * 64 + std::uint32_t(k), j = std::uint32_t(y / octave.pitch);
        const float down = octave.weight[std::size_t(y % octave.pitch)];
        lattice.resize(std::size_t(width_ / octave.pitch) + 2);
        for (std::size_t i = 0; i < lattice.size(); ++i) {
            const float above = lattice_value(std::uint32_t(i), j, salt), below = lattice_value(std::uint32_t(i), j + 1, salt);
            lattice[i] = octave.amplitude * (above + down * (below - above));
        }
        for (int x0 = 0, i = 0; x0 < width_; x0 += octave.pitch, ++i) {
            const float left = lattice[std::size_t(i)], step = lattice[std::size_t(i) + 1] - left;
            float* to = height.data() + x0;
            for (int x = 0; x < std::min(octave.pitch, width_ - x0); ++x) to[x] += left + step * octave.weight[std::size_t(x)];
        }
    }
    for (int x = 0; x < width_; ++x) out[x] = std::uint16_t(height[std::size_t(x)] * 65535.0f);
}

} // namespace reliefbake

#pragma once
// Fractal hills and valleys: value noise, each octave half as wide and half as high as the one before. Any row can be made alone.

#include <cstdint>
#include <vector>

namespace reliefbake {

class Terrain {
  public:
    /// Hills as wide as a quarter of the map's width at most, four texels at least.
    Terrain(int width, std::uint32_t seed);

    /// Row y as 16-bit heights. The same on every machine: nothing but sums and products of floats.
    void row(int y, std::uint16_t* out) const;

  private:
    struct Octave {
        int pitch;       ///< texels from one lattice point to the next
        float amplitude;
        std::vector<float> weight; ///< of the next lattice point, for each texel between two
    };

    int width_;
    std::uint32_t seed_;
    std::vector<Octave> octaves_;
};

} // namespace reliefbake

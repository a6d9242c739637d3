#pragma once
// A small generator whose numbers are the same on every platform (SplitMix64; Steele, Lea, Flood 2014).

#include <cstdint>

namespace reliefbake {

class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double uniform() { return double(next() >> 11) * 0x1p-53; }
    /// In [0, count).
    int below(int count) { return int(next() % std::uint64_t(count)); }

  private:
    std::uint64_t state_;
};

} // namespace reliefbake

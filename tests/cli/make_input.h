#pragma once
// Height maps written by hand, in the two formats whose writing needs no library.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace reliefbake::test {

/// An 8-bit PGM of code(x, y).
template <class Code>
void write_pgm(const std::filesystem::path& path, int width, int height, Code code) {
    std::string row(std::size_t(width), '\0');
    std::ofstream file(path, std::ios::binary);
    file << "P5\n" << width << ' ' << height << "\n255\n";
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            row[std::size_t(x)] = char(code(x, y));
        file << row;
    }
}

/// A PFM of value(x, y): little-endian floats, the bottom row first.
template <class Value>
void write_pfm(const std::filesystem::path& path, int width, int height, Value value) {
    std::ofstream file(path, std::ios::binary);
    file << "Pf\n" << width << ' ' << height << "\n-1.0\n";
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            const float sample = value(x, y);
            file.write(reinterpret_cast<const char*>(&sample), sizeof sample);
        }
}

/// White noise, the slowest field to bake.
inline void write_noise(const std::filesystem::path& path, int side) {
    write_pgm(path, side, side, [state = std::uint32_t(1)](int, int) mutable {
        state = state * 1664525u + 1013904223u;
        return state >> 24;
    });
}

} // namespace reliefbake::test

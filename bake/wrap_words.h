#pragma once
// The words for addressing, in files and to people.

#include "bake/texel_grid.h"

#include <array>
#include <cstddef>
#include <string>

namespace reliefbake {

constexpr std::array words_of_wraps{"repeat", "clamp"};

inline const char* word_of_wrap(Wrap wrap) { return words_of_wraps[std::size_t(wrap)]; }

/// Such as "repeat in u, clamp in v".
inline std::string addressing_of(const TexelGrid& grid) {
    return std::string(word_of_wrap(grid.wrap_x)) + " in u, " + word_of_wrap(grid.wrap_y) + " in v";
}

} // namespace reliefbake

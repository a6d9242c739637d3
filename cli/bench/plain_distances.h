#pragma once
// The textbook transform: what ours is timed against, and a second exact algorithm that checks it at full size.

#include "bake/image.h"

#include <cstdint>
#include <functional>

namespace reliefbake {

/// Exact distances to the centres of texels of 0, rounded to float, row by row in any order: Meijster, Roerdink, Hesselink (2000), figures
/// 2 and 3, with 64-bit squares. At least one texel is 0.
void plain_distances(const Image<std::uint8_t>& picture, int threads, const std::function<void(int y, const float* row)>& take_row);

} // namespace reliefbake

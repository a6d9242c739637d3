#pragma once
// Binary pictures on which distance transforms are timed: 0 in the shape.

#include "bake/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbake {

/// blobs, lines, pixel, diagonal, dots: those of docs/SHAPES.md.
const std::vector<std::string>& picture_names();

/// Same name and size, same picture on every machine.
Image<std::uint8_t> make_picture(const std::string& name, int size);

} // namespace reliefbake

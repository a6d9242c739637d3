#pragma once
// The meaning of a shape map as JSON, both ways. Keys: docs/FORMATS.md.

#include "formats/shape_file.h"

#include <string>
#include <vector>

namespace reliefbake {

/// A shape map's facts as its file tells them; the texels' number and type come from the image.
struct ShapeFacts {
    std::string kind;
    ShapeMapInfo info;
    Wrap wrap_x = Wrap::clamp, wrap_y = Wrap::clamp;
    std::vector<std::string> bad_keys; ///< missing, or values that make no sense
};

/// Never fails: what is no JSON object has kind "".
ShapeFacts shape_facts_from(const std::string& text);

/// Names in the file of gradient x, gradient y, distance and shape.
std::vector<std::string> shape_channels(const ShapeMapInfo& info);

} // namespace reliefbake

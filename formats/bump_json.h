#pragma once
// The meaning of a bump map as JSON, both ways. Keys: docs/FORMATS.md.

#include "formats/bump_file.h"

#include <string>
#include <vector>

namespace reliefbake {

/// A bump map's facts as its file tells them; the texels' number and type come from the image.
struct BumpFacts {
    std::string kind; ///< as it stands there; "" where the file says none
    BumpMapInfo info; ///< of a kind that bump_kind_of knows
    Wrap wrap_x = Wrap::clamp, wrap_y = Wrap::clamp;
    double pixel_aspect = 1;
    std::vector<std::string> bad_keys; ///< missing, or values that make no sense
};

/// Never fails: what is no JSON object has kind "".
BumpFacts bump_facts_from(const std::string& text);

} // namespace reliefbake

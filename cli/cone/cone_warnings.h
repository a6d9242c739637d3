#pragma once
// What a person should know about a bake that went well.

#include "bake/cone.h"
#include "cli/cone/cone_options.h"
#include "formats/read_image.h"

#include <string>
#include <vector>

namespace reliefbake {

/// One line each, beginning with the file: an sRGB tag on heights; a format that keeps no metadata; lost
/// cones (code 0), with the encoding that would lose the fewest, found by trying the others at the cost of an
/// encoding pass each.
std::vector<std::string> cone_warnings(const ConeCommandOptions& given, const SourceImage& source,
                                       const DepthMap& depth, const std::vector<ConeMap>& cones,
                                       const std::vector<EncodedConeMap>& encoded);

} // namespace reliefbake

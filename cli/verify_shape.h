#pragma once
// reliefbake verify MAP, where MAP is a shape map.

#include "cli/solid_options.h"
#include "shaders-reference/measure/verify_shape.h"

#include <string>

namespace reliefbake {

/// Judges every kind of solid and prints the report. `options` comes with what the command line says beside `solid`; `pictures`: a
/// folder, or empty.
Result<void> verify_shape_file(const std::string& file, const SolidOptions& solid, ShapeVerifyOptions options, bool json,
                               const std::string& pictures);

} // namespace reliefbake

#pragma once
// reliefbake verify MAP, where MAP is a shape map.

#include "cli/options/solid_options.h"
#include "shaders-reference/measure/verify_shape.h"

#include <string>

namespace reliefbake {

/// A file, and the budget of its decoded image.
struct ShapeFile {
    std::string name;
    std::uint64_t max_bytes;
};

/// Judges every kind of solid and prints the report. `options` comes with what the command line says beside `solid`; `pictures`: a
/// folder, or empty.
Result<void> verify_shape_file(const ShapeFile& file, const SolidOptions& solid, ShapeVerifyOptions options, bool json,
                               const std::string& pictures);

} // namespace reliefbake

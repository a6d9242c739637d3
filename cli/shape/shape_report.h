#pragma once
// What `reliefbake shape` tells: one object for scripts, a few lines for people, warnings.

#include "bake/shape_map.h"
#include "cli/shape/shape_options.h"
#include "cli/stage_clock.h"
#include "formats/read_image.h"

#include <string>
#include <vector>

namespace reliefbake {

/// Everything a finished bake knows about itself.
struct ShapeRun {
    const ShapePlan& plan;
    const SourceImage& source; ///< its plane is gone
    const ShapeMapInfo& info;
    const TexelGrid& grid;
    std::vector<std::string> warnings;
    const StageClock::Seconds& seconds;
};

/// Lawful, but rarely meant.
std::vector<std::string> shape_warnings(const ShapeCommandOptions& options, const BinaryShape& shape, const ShapeMapInfo& info);

/// The object of --json: cli/schema/shape.schema.json.
std::string shape_result_text(const ShapeRun& run);

/// A few lines for a person.
std::string shape_summary(const ShapeRun& run);

} // namespace reliefbake

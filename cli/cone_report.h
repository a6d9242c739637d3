#pragma once
// What `reliefbake cone` tells: one object for scripts, a few lines for people, warnings.

#include "bake/height_field.h"
#include "bake/relief_map.h"
#include "cli/cone_options.h"
#include "cli/stage_clock.h"
#include "formats/read_image.h"

#include <string>
#include <vector>

namespace reliefbake {

/// Everything a finished bake knows about itself.
struct ConeRun {
    const ConePlan& plan;
    const SourceImage& source; ///< its plane may be gone
    const HeightReport& height;
    const ReliefMapInfo& info;
    const TexelGrid& grid;
    std::vector<std::string> warnings;
    const StageClock::Seconds& seconds;
};

/// The object of --json: cli/schema/cone.schema.json.
std::string cone_result_text(const ConeRun& run);

/// A few lines for a person.
std::string cone_summary(const ConeRun& run);

} // namespace reliefbake

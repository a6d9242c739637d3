#pragma once
// What `reliefbake bump` tells: one object for scripts, a few lines for people, warnings.

#include "cli/bump/bump_options.h"
#include "cli/stage_clock.h"
#include "formats/read_image.h"

#include <string>
#include <vector>

namespace reliefbake {

/// Everything a finished bake knows about itself.
struct BumpRun {
    const BumpPlan& plan;
    const SourceImage& source; ///< its plane may be gone
    const HeightReport& height;
    const BumpMapInfo& info;
    const TexelGrid& grid;
    std::vector<std::string> warnings;
    const StageClock::Seconds& seconds;
};

std::vector<std::string> bump_warnings(const BumpPlan& plan, const SourceImage& source);

/// The object of --json: cli/schema/bump.schema.json.
std::string bump_result_text(const BumpRun& run);

/// A few lines for a person.
std::string bump_summary(const BumpRun& run);

} // namespace reliefbake

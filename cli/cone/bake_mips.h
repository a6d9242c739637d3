#pragma once
// A bake of a whole mip chain.

#include "bake/height_field.h"
#include "cli/cone/cone_options.h"
#include "cli/cone/cone_report.h"
#include "cli/cone/stored_height.h"
#include "cli/stage_clock.h"
#include "formats/atomic_file.h"

#include <string>
#include <vector>

namespace reliefbake {

/// What a finished chain tells.
struct MipRun {
    ReliefMapInfo info; ///< of level 0
    std::vector<MipReport> levels;
    std::vector<std::string> warnings;
};

/// Level 0, and the pyramids that other bakes of it may have made.
struct MipBase {
    const DepthMap& depth;
    SharedPyramids* pyramids;
};

/// Bakes every level of the chain of `base` and adds it to the batch, for the plan's output.
/// Errors: those of write_map_levels.
Result<MipRun> bake_mips(const ConePlan& plan, const BakeSource& source, const MipBase& base, FileBatch& batch, StageClock& clock);

} // namespace reliefbake

#pragma once
// `reliefbake cone` out of core: heights on the disk, bands of rows baked and written one after the other (docs/LARGE.md).

#include "cli/cone/bake_maps.h"
#include "cli/cone/large/memory_plan.h"

#include <optional>

namespace reliefbake {

/// What became of a run out of core.
struct BakedBands {
    BakedMaps baked; ///< of one map; with --rows its statistics are those of the surface alone
    LargeReport report;
};

/// How a run bakes that may be too large: empty in core. Errors (usage): an option out of core that a map in bands has not, or the
/// output's format; budget: a ceiling given that neither way can keep.
Result<std::optional<MemoryPlan>> plan_bands(const std::vector<ConePlan>& plans);

/// Errors: those of read_image_into, make_height_field, FileBatch, write_joined_map.
Result<BakedBands> bake_bands(const ConePlan& plan, const MemoryPlan& memory);

} // namespace reliefbake

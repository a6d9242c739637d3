#pragma once
// The stages of every cone command: read, bake, encode, write. One run may make several maps of one source (--also).

#include "cli/cone/cone_options.h"
#include "cli/cone/cone_report.h"
#include "cli/cone/stored_height.h"

#include <memory>
#include <string>
#include <vector>

namespace reliefbake {

/// What became of one map.
struct BakedMap {
    ConePlan plan;
    ReliefMapInfo info; ///< of level 0
    TexelGrid grid;
    std::vector<std::string> warnings;
    StageClock::Seconds seconds; ///< of the stages that only it needed; those that all share count for the first
    std::vector<MipReport> levels; ///< with --mips
};

struct BakedMaps {
    BakeSource source;
    std::vector<BakedMap> maps; ///< in the order of the plans
};

/// Bakes a map for each plan; all have the source options of the first. They share the decoded image, the checked heights, and for
/// each depth of bits what is stored, its pyramids and normals, and equal cones; each has the bytes that it has alone.
/// All or nothing: files appear when all are complete on the disk.
/// Errors: those of read_source, write_map.
Result<BakedMaps> bake_maps(const std::vector<ConePlan>& plans);

} // namespace reliefbake

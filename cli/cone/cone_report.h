#pragma once
// What `reliefbake cone` tells: one object for scripts, a few lines for people, warnings.

#include "bake/height_field.h"
#include "bake/relief_map.h"
#include "cli/cone/cone_options.h"
#include "cli/stage_clock.h"
#include "formats/read_image.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// One level of a mip chain.
struct MipReport {
    std::string output; ///< the file that holds it
    TexelGrid grid;
    std::map<std::string, double> statistics;
};

/// Of a bake out of core.
struct LargeReport {
    int first, end;              ///< rows baked
    int band_rows;               ///< of them at a time
    std::uint64_t memory;        ///< the ceiling, bytes
    std::uint64_t working_space; ///< taken on the disk beside the output, bytes
    bool pyramid_in_memory;
};

/// Everything a finished bake knows about itself.
struct ConeRun {
    const ConePlan& plan;
    const SourceImage& source; ///< its plane may be gone
    const HeightReport& height;
    const ReliefMapInfo& info;
    const TexelGrid& grid;
    std::vector<std::string> warnings;
    const StageClock::Seconds& seconds;
    std::vector<MipReport> levels; ///< with --mips: all of them, level 0 first
    std::optional<LargeReport> large; ///< out of core
};

/// The object of --json: cli/schema/cone.schema.json. The first map's, and in `also` the others'.
std::string cone_result_text(const std::vector<ConeRun>& runs);

/// A few lines for a person.
std::string cone_summary(const ConeRun& run);

} // namespace reliefbake

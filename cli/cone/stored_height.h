#pragma once
// The stages that every bake of a height map begins with: read, check, quantise.

#include "bake/height_field.h"
#include "cli/cone/cone_options.h"
#include "cli/stage_clock.h"
#include "formats/read_image.h"

#include <memory_resource>
#include <optional>
#include <string>

namespace reliefbake {

/// A decoded and validated height map.
struct BakeSource {
    SourceImage image;      ///< its plane is gone
    std::string alpha_hash; ///< of the plane that its holes come from; empty: it knows none
    HeightReport report;
    std::optional<HeightField> field; ///< until it is stored
};

/// Times the stages "read", "alpha" (if there is one) and "height".
/// Errors: those of read_image, read_alpha, make_height_field; usage (a --no-data that the file cannot hold).
Result<BakeSource> read_source(const ConeCommandOptions& given, StageClock& clock);

/// The same with the heights in `storage`, and no memory that grows with them; without an alpha.
Result<BakeSource> read_source_into(std::pmr::memory_resource& storage, const ConeCommandOptions& given, StageClock& clock);

/// The stored surface, and where it comes from.
struct StoredHeight {
    SourceImage source; ///< its plane is gone
    HeightReport report;
    DepthMap depth;
};

/// read_source, then the stage "quantise".
Result<StoredHeight> read_stored_height(const ConeCommandOptions& given, BitDepth bits, StageClock& clock);

} // namespace reliefbake

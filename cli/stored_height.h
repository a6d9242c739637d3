#pragma once
// The stages that every bake of a height map begins with: read, check, quantise.

#include "bake/height_field.h"
#include "cli/cone_options.h"
#include "cli/stage_clock.h"
#include "formats/read_image.h"

namespace reliefbake {

/// The stored surface, and where it comes from.
struct StoredHeight {
    SourceImage source; ///< its plane is gone
    HeightReport report;
    DepthMap depth;
};

/// Times the stages "read", "height" and "quantise".
Result<StoredHeight> read_stored_height(const ConeCommandOptions& given, BitDepth bits, StageClock& clock);

} // namespace reliefbake

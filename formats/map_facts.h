#pragma once
// What a map's file means: its metadata, overruled by what the user says.

#include "formats/image_gate.h"
#include "formats/map_file.h"
#include "formats/map_layout.h"

#include <string>
#include <vector>

namespace reliefbake {

/// A map before its pixels are read.
struct MapFacts {
    ReliefMapInfo info;
    TexelGrid grid;
    std::vector<LayoutImage> images; ///< channel "-" is absent; empty for a kind of a later version
};

/// Errors: bad_data (damaged metadata, samples that no map has, facts missing: names the flags that supply them);
/// usage (hints.channel_order). `is_targa`: a format that cannot say anything. `name` is the file, for messages.
Result<MapFacts> map_facts(const ImageClaims& claims, bool is_targa, const MapHints& hints, const std::string& name);

/// The bit depth of a map's samples; bad_data for samples that no map has.
Result<BitDepth> bits_of_map(const ImageClaims& claims, const std::string& name);

/// "a, b, c"
std::string join(const std::vector<std::string>& words);

} // namespace reliefbake

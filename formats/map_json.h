#pragma once
// The meaning of a map as JSON: what lies in the file, and what `explain --json` prints. Keys: docs/FORMATS.md.

#include "bake/relief_map.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// Every fact, keys as in docs/FORMATS.md. An infinite cone_max or statistic is the string "inf": JSON has no infinity.
nlohmann::json to_json(const ReliefMapInfo& info, const TexelGrid& grid);

/// What a file says; a fact is empty when the file is silent.
struct MapMetadata {
    std::optional<std::string> kind;
    std::optional<Metric> metric;
    std::optional<ConeEncoding> encoding;
    std::optional<SurfaceModel> surface;
    std::optional<NormalY> normal_y;
    std::optional<ChannelLayout> layout;
    std::optional<ConeFamily> family;
    std::optional<RelaxedRays> rays;
    std::optional<ConeLookup> lookup;
    std::optional<double> relaxed_slope, hybrid_delta;
    std::optional<int> planes, levels;
    std::optional<bool> trilinear, holes;
    std::optional<Wrap> wrap_x, wrap_y;
    std::optional<float> cone_max;
    std::optional<double> depth_scale, pixel_aspect, filter_delta, tolerance;
    std::optional<std::vector<std::string>> channels; ///< names of the file's channels; of kind cone in the order nx, ny, cone, depth
    std::string guarantee, version, source_hash, alpha_hash, argument_hash;
    std::map<std::string, double> statistics;
    /// Keys that are there and make no sense (wrong type, not finite, out of range, unknown word); such facts are empty.
    std::vector<std::string> bad_keys;
};

/// Reads what is there, believes nothing; any text is safe. Unknown keys are ignored: later versions may add some.
MapMetadata map_metadata_from(const std::string& text);

} // namespace reliefbake

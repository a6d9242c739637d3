#pragma once
// Bands of rows, baked apart, to the map that one run would have written.

#include "bake/error.h"

#include <string>
#include <vector>

namespace reliefbake {

enum class MergeOutput { text, json, none };

/// Errors: usage (the output is one of the bands, or cannot hold the map), no_input, bad_data (no bands of one map, rows missing or
/// there twice, damaged), cannot_create, write_failed, internal.
Result<void> merge_bands(const std::vector<std::string>& files, const std::string& output, int threads, MergeOutput report);

} // namespace reliefbake

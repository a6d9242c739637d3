#pragma once
// The lines of `explain` that maps of every kind have.

#include "bake/bit_depth.h"
#include "bake/texel_grid.h"

#include <map>
#include <string>

namespace reliefbake {

/// "A cone map of 8 x 8 texels, 16 bits, by reliefbake 0.1.0."
std::string title_line(const std::string& kind, const TexelGrid& grid, BitDepth bits, const std::string& version);

/// A line a number.
std::string statistics_lines(const std::map<std::string, double>& statistics);

/// The hashes of source and options; nothing where the file has none.
std::string source_line(const std::string& source_hash, const std::string& argument_hash);

} // namespace reliefbake

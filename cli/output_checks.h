#pragma once
// What every bake asks of its output and proportions before it works.

#include "cli/cone/cone_options.h"

#include <filesystem>
#include <string>

namespace reliefbake {

/// ".exr", in lower case.
std::string extension_of(const std::string& path);

/// The deepest codes that every program can read back from the format.
BitDepth default_bits(const std::string& output);

/// Refuses (usage) an output that is the input file.
Result<void> validate_not_input(const std::string& input, const std::string& output);

/// Before the work, so that none is lost; the writer checks again. Errors: cannot_create.
Result<void> validate_output_folder(const std::string& output);

/// A name by which two files are told apart, links followed, without regard to the case of its letters.
std::string identity_of(const std::filesystem::path& file);

/// Depth of the relief in texture widths: --depth / --size, or --depth-uv.
double depth_scale_of(const ConeCommandOptions& options);

/// Refuses (usage) a depth that is none, or beyond 1e6 texture widths.
Result<void> validate_depth_scale(double scale);

} // namespace reliefbake

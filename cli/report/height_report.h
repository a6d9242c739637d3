#pragma once
// What every bake of a height map tells about the heights.

#include "bake/height_field.h"
#include "cli/cone/cone_options.h"
#include "formats/read_image.h"

#include <nlohmann/json.hpp>

#include <string>

namespace reliefbake {

/// Keys input, output, source, range, wrap, seam: cli/schema/cone.schema.json.
nlohmann::json height_result(const ConeCommandOptions& given, const SourceImage& source, const HeightReport& height,
                             const TexelGrid& grid);

/// The same for a person, in three lines.
std::string height_summary(const ConeCommandOptions& given, const SourceImage& source, const HeightReport& height,
                           const TexelGrid& grid);

} // namespace reliefbake

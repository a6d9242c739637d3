#pragma once
// The shader that decodes one shape map and follows rays to its extrusion, to take away.

#include "bake/shape_map.h"
#include "shaders-reference/renderer/shader_export.h"

#include <string>

namespace reliefbake {

/// A whole fragment shader: the decoder with the map's metadata as constants, circle tracing, and an entry point that shows its use
/// on a polygon. Planes of the map are not looked at.
std::string export_shape_shader(const ShapeMap& map, ShaderLanguage language);

} // namespace reliefbake

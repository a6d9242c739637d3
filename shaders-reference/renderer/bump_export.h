#pragma once
// The shader that decodes one bump map, to take away.

#include "bake/bump_map.h"
#include "shaders-reference/renderer/shader_export.h"

#include <string>

namespace reliefbake {

/// A whole fragment shader: the decoder with the map's metadata as constants, and an entry point that shows its use.
std::string export_bump_shader(const BumpMap& map, ShaderLanguage language);

} // namespace reliefbake

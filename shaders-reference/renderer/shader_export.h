#pragma once
// The texts of glsl/ for one map, as a shader to take away: what does not concern the map is left out, and its metadata
// are constants. HLSL is the same text in other words.

#include "bake/error.h"
#include "bake/relief_map.h"

#include <string>

namespace reliefbake {

enum class ShaderLanguage { glsl, glsl_es, hlsl }; ///< 3.30 core; ES 3.00; HLSL, Shader Model 4

/// A whole shader of a body in GLSL; `comment` comes before it, and its samplers read a map of `grid`.
std::string in_language(ShaderLanguage language, const std::string& comment, const std::string& body, const TexelGrid& grid);

/// A whole fragment shader: decoding, the march that suits the map, and an entry point that shows its use.
/// Errors (usage): the map has no cones, or no depth.
Result<std::string> export_shader(const ReliefMap& map, ShaderLanguage language);

} // namespace reliefbake

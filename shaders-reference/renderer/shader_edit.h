#pragma once
// What turns the texts of glsl/ into one for a map: branches taken, uniforms made constants, other words for HLSL.

#include "bake/texel_grid.h"
#include "shaders-reference/renderer/shader_source.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbake {

using UniformValues = std::vector<std::pair<std::string, std::string>>; ///< name and value, as written

/// Nine digits bring a float back; always with a point or an exponent, so that it is a float in every language.
std::string float_literal(double number);

/// Takes the branches of #if that hold, puts numbers for the names of constants, and leaves out the comments that explain
/// these names.
std::string specialise(std::string_view text, const std::vector<ShaderConstant>& constants);

/// "uniform TYPE NAME;" becomes "const TYPE NAME = VALUE;". Samplers stay.
std::string fix_uniforms(const std::string& text, const UniformValues& values);

/// The same shader in HLSL. glsl/ keeps to what translates word by word: no struct constructors, no splats.
std::string to_hlsl(std::string text, const TexelGrid& grid);

} // namespace reliefbake

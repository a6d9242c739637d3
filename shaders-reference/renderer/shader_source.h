#pragma once
// The shader texts of glsl/, and their concatenation into programs.

#include "bake/relief_map.h"

#include <string>
#include <string_view>
#include <vector>

namespace reliefbake {

/// How a ray is followed. `given` shades hits that were computed elsewhere.
enum class Technique { cone, cone_published, linear, binary, given };

/// Everything that is fixed when a program is compiled.
struct ShaderConfig {
    ConeEncoding encoding = ConeEncoding::sqrt;
    Metric metric = Metric::l2;
    bool normal_unorm = true; ///< normals stored as 0.5 n + 0.5
    NormalY normal_y = NormalY::gl;
    Technique technique = Technique::cone;
    bool exact_finish = false; ///< cone only

    friend bool operator==(const ShaderConfig&, const ShaderConfig&) = default;
};

/// The configuration that decodes `info`.
ShaderConfig shader_config(const ReliefMapInfo& info, Technique technique, bool exact_finish);

/// The first lines of a shader, which choose the language.
enum class Prelude { core330, core450, es300 };

std::string vertex_source(Prelude prelude);
std::string fragment_source(const ShaderConfig& config, Prelude prelude);

struct ShaderText {
    std::string_view name; ///< file name in glsl/
    std::string_view text;
};

/// All files of glsl/, as they were when the program was configured.
const std::vector<ShaderText>& shader_texts();

} // namespace reliefbake

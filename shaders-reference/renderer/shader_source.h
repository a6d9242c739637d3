#pragma once
// The shader texts of glsl/, and their concatenation into programs.

#include "bake/relief_map.h"
#include "shaders-reference/renderer/technique.h"

#include <string>
#include <string_view>
#include <vector>

namespace reliefbake {

/// How the sun's light is cut off (001 sec. 4.4). Soft edges are guesses; the march to the sun misses what is thinner than its step.
enum class Shadow {
    none,
    hard,        ///< a ray that dips under the relief sees nothing
    height_soft, ///< by the least height of the ray above the relief on its way
    cone_soft,   ///< by the least distance that a cone keeps free around it; conservative cones only
    horizon,     ///< no march: by a baked horizon map (ReliefRenderer::load_horizons)
};

/// How much of the sky a point sees (001 sec. 4.5); conservative cones only.
enum class Ambient {
    none,        ///< all of it
    cone,        ///< the cone ratio, as stored cones have it, at most 1
    cone_normal, ///< the cone's n_z, in the relief's true proportions
};

/// Everything that is fixed when a program is compiled.
struct ShaderConfig {
    ConeEncoding encoding = ConeEncoding::sqrt;
    Metric metric = Metric::l2;
    bool normal_unorm = true; ///< normals stored as 0.5 n + 0.5
    NormalY normal_y = NormalY::gl;
    int sectors = 0;          ///< 0: one cone for all; 4, 8
    int levels = 1;           ///< cones stacked, or pieces, 1 to 8
    bool pieces = false;      ///< the levels are pieces of one cone
    ConeLookup lookup = ConeLookup::filtered;
    bool holes = false;       ///< depth 1 is a hole
    bool empty_cones = true;  ///< nothing of the relief is inside: shadow rays may leap too
    Technique technique = Technique::cone;
    bool exact_finish = false; ///< Technique::cone, cone_raw
    Shadow shadow = Shadow::none;
    Ambient ambient = Ambient::cone_normal;

    friend bool operator==(const ShaderConfig&, const ShaderConfig&) = default;
};

/// Ratio that stands for "no cap" (inf) in shaders: finite, so that 0 times it is 0.
constexpr float widest_ratio = 1e6f;

/// How far a sampler that filters 8-bit textures in 8 bits may err in a code (relief_code_delta).
constexpr float filtered_code_error = 2.0f / 255;

/// The configuration that decodes `map`, with everything else as by default.
ShaderConfig shader_config(const ReliefMap& map, Technique technique, bool exact_finish);

/// The first lines of a shader, which choose the language.
enum class Prelude { core330, core450, es300 };

std::string prelude_text(Prelude prelude);
std::string vertex_source(Prelude prelude);
std::string fragment_source(const ShaderConfig& config, Prelude prelude);

/// The numbers that a configuration fixes, by the names that glsl/ gives them.
struct ShaderConstant {
    std::string_view name;
    int value;
};
std::vector<ShaderConstant> shader_constants(const ShaderConfig& config);

/// A file of glsl/.
std::string_view shader_text(std::string_view name);

struct ShaderText {
    std::string_view name; ///< file name in glsl/
    std::string_view text;
};

/// All files of glsl/, as they were when the program was configured.
const std::vector<ShaderText>& shader_texts();

} // namespace reliefbake

#pragma once
// The shader text that draws a solid of a shape map.

#include "bake/shape_map.h"
#include "shaders-reference/renderer/shader_source.h"
#include "shaders-reference/solid.h"

#include <string>

namespace reliefbake {

/// How a ray is followed to the solid.
enum class CircleScheme {
    corrected, ///< steps that never enter the solid (MATHS section 6)
    published, ///< as printed in 003 and 004, for comparison
    given,     ///< hits that were computed elsewhere
};

/// How a texture lies on the solid.
enum class Projection {
    planar,      ///< as the map itself: extrusions
    cylindrical, ///< angle around the axis, height: revolutions
    spherical,   ///< longitude and latitude about the solid's middle: revolutions
};

/// Everything that is fixed when a program is compiled.
struct SolidConfig {
    bool unorm = true;
    bool signed_distance = false;
    SolidKind kind = SolidKind::extrusion;
    bool on_plane = false;
    CircleScheme scheme = CircleScheme::corrected;
    Projection projection = Projection::planar;
    bool colour = false, bump = false, shadow = false;

    friend bool operator==(const SolidConfig&, const SolidConfig&) = default;
};

std::string solid_fragment_source(const SolidConfig& config, Prelude prelude);

} // namespace reliefbake

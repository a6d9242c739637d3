#pragma once
// Heights at the ends of what numbers, sizes and proportions allow.

#include "bake/height_field.h"

#include <functional>
#include <string>
#include <vector>

namespace reliefbake {

struct StressField {
    std::string name; ///< without spaces
    int width = 1, height = 1;
    /// Source value at a texel; `quantum`: quantum_of the format stored.
    std::function<double(int x, int y, double quantum)> value;
    RangeMode range = RangeMode::automatic;
    double pixel_aspect = 1;
    double depth_scale = 0.1; ///< of the relief in texture widths
    std::vector<double> angles = {0, 45, 80, 89.9}; ///< of the views, degrees from the plane's normal
    bool march = true; ///< false: too large for a texture of floats; its cones alone are judged, in doubles
    bool exact = true; ///< judged in rational numbers, too
};

enum class StressExtent {
    quick,    ///< numbers and depth scales on 16 x 16 texels, sides up to 1024
    standard, ///< on 32 x 32 texels, sides up to 16384
    full,     ///< 16384 x 16384, too
};

std::vector<StressField> stress_fields(StressExtent extent);

/// One code of a format for depths from 1/2 up.
double quantum_of(BitDepth bits);

/// Independent values in [0, 1), the same on every machine.
double stress_noise(int x, int y);

} // namespace reliefbake

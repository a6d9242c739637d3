#pragma once
// What the reference renderer shows: a horizontal plane of relief under a perspective camera and one sun.
// World: x along u, y up the image, z up; unit: one texture width; the plane, the relief's top, is z = 0.

#include "bake/texel_grid.h"

#include <array>

namespace reliefbake {

using Vec3 = std::array<double, 3>;

struct View {
    double angle = 45;         ///< between the line of sight and the plane's normal, degrees: 0 from above, < 90 (--view)
    double azimuth = 0;        ///< heading of the line of sight, degrees clockwise from "up the image" (--azimuth)
    double field_of_view = 30; ///< across the picture's width, degrees
    double span = 0;           ///< texture widths seen across the picture at the target; 0: the whole plane
};

struct Sun {
    double azimuth = -55;  ///< direction the light comes from, degrees clockwise from the camera's heading
    double elevation = 30; ///< above the plane, degrees, > 0
};

struct Camera {
    Vec3 eye, forward;
    Vec3 right, up; ///< half the picture's width and height at distance 1
    double near, far;
};

/// A camera that looks at the centre of `tiles` x `tiles` repeats (one for clamped maps).
Camera make_camera(const TexelGrid& grid, const View& view, int tiles, double picture_aspect);

/// A camera that looks at a ball and sees all of it. The view's angle goes from 0, from above, to 180, from below; its span is not used.
Camera make_orbit_camera(const Vec3& middle, double radius, const View& view, double picture_aspect);

/// Unit vector towards the light.
Vec3 sun_direction(const Sun& sun, const View& view);

} // namespace reliefbake

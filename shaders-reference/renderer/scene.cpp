#include "shaders-reference/renderer/scene.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double frame_margin = 1.25; ///< the whole plane leaves this much air around it; its near corners need some

Vec3 scaled(const Vec3& v, double factor) { return {v[0] * factor, v[1] * factor, v[2] * factor}; }

/// Looks at `middle` from `distance`, along the view's line of sight.
Camera camera_at(const Vec3& middle, double distance, const View& view, double picture_aspect) {
    const double sin_angle = std::sin(view.angle * degree), cos_angle = std::cos(view.angle * degree);
    const double sin_heading = std::sin(view.azimuth * degree), cos_heading = std::cos(view.azimuth * degree);
    const double half = std::tan(0.5 * view.field_of_view * degree);
    Camera camera;
    camera.forward = {sin_angle * sin_heading, sin_angle * cos_heading, -cos_angle};
    for (std::size_t k = 0; k < 3; ++k) camera.eye[k] = middle[k] - distance * camera.forward[k];
    camera.right = scaled({cos_heading, -sin_heading, 0}, half);
    camera.up = scaled({cos_angle * sin_heading, cos_angle * cos_heading, sin_angle}, half / picture_aspect);
    camera.near = 0.01 * distance;
    camera.far = 1000 * distance;
    return camera;
}

} // namespace

Camera make_camera(const TexelGrid& grid, const View& view, int tiles, double picture_aspect) {
    const double cos_angle = std::cos(view.angle * degree);
    const double sin_heading = std::sin(view.azimuth * degree), cos_heading = std::cos(view.azimuth * degree);
    const double half = std::tan(0.5 * view.field_of_view * degree);
    const double across = std::abs(cos_heading) + std::abs(sin_heading) * grid.aspect();
    const double ahead = std::abs(sin_heading) + std::abs(cos_heading) * grid.aspect();
    const double plane_span = frame_margin * tiles * std::max(across, ahead * cos_angle * picture_aspect);
    const double distance = 0.5 * (view.span > 0 ? view.span : plane_span) / half;

    return camera_at({0.5 * tiles, -0.5 * tiles * grid.aspect(), 0}, distance, view, picture_aspect);
}

Camera make_orbit_camera(const Vec3& middle, double radius, const View& view, double picture_aspect) {
    // The tangent cone of the ball, in the narrower of the picture's two fields of view.
    const double half = std::atan(std::tan(0.5 * view.field_of_view * degree) / std::max(1.0, picture_aspect));
    return camera_at(middle, radius / std::sin(half), view, picture_aspect);
}

Vec3 sun_direction(const Sun& sun, const View& view) {
    const double heading = (view.azimuth + sun.azimuth) * degree;
    const double flat = std::cos(sun.elevation * degree);
    return {flat * std::sin(heading), flat * std::cos(heading), std::sin(sun.elevation * degree)};
}

} // namespace reliefbake

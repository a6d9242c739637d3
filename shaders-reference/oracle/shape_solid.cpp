#include "shaders-reference/oracle/shape_solid.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Point3 point_at(const SolidRay& ray, double t) {
    Point3 point;
    for (std::size_t k = 0; k < 3; ++k) point[k] = ray.origin[k] + (ray.direction[k] != 0 ? t * ray.direction[k] : 0);
    return point;
}

struct MapPlace {
    double u, v, z;
};

MapPlace place_of(const ShapeSolid& solid, const Point3& p) {
    if (solid.kind == SolidKind::extrusion) return {p[0], p[1], p[2]};
    return {solid.axis + std::hypot(p[0], p[1]), p[2], p[2]};
}

/// How fast the distance of a point on the ray can change, texture widths per unit of t.
double speed_of(const ShapeSolid& solid, double aspect, const Point3& d) {
    if (solid.kind == SolidKind::extrusion) return std::hypot(d[0], aspect * d[1]);
    return std::hypot(d[0], d[1], aspect * d[2]);
}

/// t of the ray's next way out of [low, high] on one axis.
double slab_exit(double origin, double direction, double low, double high) {
    if (direction == 0) return infinity;
    return std::max(0.0, ((direction > 0 ? high : low) - origin) / direction);
}

// The distance falls by `speed` at most, and min(z, c) grows by dz above c, not at all below it:
//
//     z < c:   step = max( gap / (speed + b dz), (D - e - b c) / speed )    nothing of the solid is farther out than its foot
//     z >= c:  step = gap / speed
//
// A denominator <= 0: the ray flees and never arrives.
double safe_step(const ShapeSolid& solid, double gap, double z, double speed, double dz) {
    const bool widening = z < solid.chamfer;
    const auto quotient = [](double way, double rate) { return rate > 0 ? way / rate : infinity; };
    const double closing = speed + (widening && solid.bevel > 0 ? solid.bevel * dz : 0);
    const double along_bevel = quotient(gap, closing);
    if (!widening || !std::isfinite(solid.chamfer)) return along_bevel;
    const double beyond_foot = gap - solid.bevel * (solid.chamfer - z);
    return beyond_foot > 0 ? std::max(along_bevel, quotient(beyond_foot, speed)) : along_bevel;
}

} // namespace

double domain_exit(const TexelGrid& grid, const ShapeSolid& solid, const SolidRay& ray) {
    const Point3 &o = ray.origin, &d = ray.direction;
    if (solid.kind == SolidKind::extrusion) {
        const auto side_exit = [&](std::size_t axis, Wrap wrap) {
            return solid.on_plane && wrap == Wrap::repeat ? infinity : slab_exit(o[axis], d[axis], 0, solid.tiles);
        };
        return std::min({slab_exit(o[2], d[2], 0, 1), side_exit(0, grid.wrap_x), side_exit(1, grid.wrap_y)});
    }
    // |o + t d|^2 = radius^2, its larger root.
    const double radius = 1 - solid.axis, a = d[0] * d[0] + d[1] * d[1];
    const double half_b = o[0] * d[0] + o[1] * d[1], c = o[0] * o[0] + o[1] * o[1] - radius * radius;
    const double sideways = a > 0 ? std::max(0.0, (std::sqrt(std::max(0.0, half_b * half_b - a * c)) - half_b) / a) : infinity;
    return std::min(sideways, slab_exit(o[2], d[2], 0, solid.tiles));
}

double solid_gap(const PixelShape& shape, const ShapeSolid& solid, const Point3& point) {
    const MapPlace place = place_of(solid, point);
    const double widened = solid.bevel > 0 ? solid.bevel * std::min(place.z, solid.chamfer) : 0;
    return shape.signed_distance(place.u, place.v) - solid.outward - widened;
}

Point3 solid_normal(const PixelShape& shape, const ShapeSolid& solid, const Point3& point) {
    const MapPlace place = place_of(solid, point);
    const bool inside = shape.contains(place.u, place.v);
    const NearestPoint nearest = shape.nearest(place.u, place.v, !inside);
    const double aspect = shape.grid().aspect();
    const double sign = inside ? -1 : 1;
    double x = sign * (place.u - nearest.u), y = sign * aspect * (place.v - nearest.v);
    const double length = std::hypot(x, y);
    if (!(length > 0) || !std::isfinite(nearest.distance)) return {0, 0, 1};
    x /= length, y /= length;

    const double tall = solid.kind == SolidKind::extrusion ? solid.depth_scale : aspect;
    const double lean = place.z < solid.chamfer ? solid.bevel / tall : 0; // -b dz/dz_world
    Point3 normal{x, -y, lean};
    if (solid.kind == SolidKind::revolution) {
        const double radius = std::hypot(point[0], point[1]);
        normal = {radius > 0 ? x * point[0] / radius : x, radius > 0 ? x * point[1] / radius : 0, -y + lean};
    }
    const double norm = std::hypot(normal[0], normal[1], normal[2]);
    if (!(norm > 0)) return {0, 0, 1};
    for (double& component : normal) component /= norm;
    return normal;
}

std::optional<double> first_solid_hit(const PixelShape& shape, const ShapeSolid& solid, const SolidRay& ray, double lowered_by, double t_max) {
    const TexelGrid& grid = shape.grid();
    const Point3& d = ray.direction;
    const double speed = speed_of(solid, grid.aspect(), d);
    const double length = std::hypot(speed, d[2]);
    const double shortest = chord_tolerance * std::min(grid.pitch_x(), grid.pitch_y()) / length;
    const auto gap_at = [&](double t) { return solid_gap(shape, solid, point_at(ray, t)) + lowered_by; };

    // Step while nothing can lie between.
    double before = 0, t = 0;
    while (true) {
        const double gap = gap_at(t);
        if (gap <= 0) break;
        const double z = place_of(solid, point_at(ray, t)).z;
        const double step = safe_step(solid, gap, z, speed, d[2]);
        if (t >= t_max || step > t_max - t) return std::nullopt;
        before = t;
        t = std::min(t + std::max(step, shortest), t_max);
    }
    // Halve the last step: outside at `before`, inside at t.
    for (int i = 0; i < 60 && before < t; ++i) {
        const double middle = 0.5 * (before + t);
        if (middle <= before || middle >= t) break;
        (gap_at(middle) <= 0 ? t : before) = middle;
    }
    return t;
}

} // namespace reliefbake

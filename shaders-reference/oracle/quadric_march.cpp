#include "shaders-reference/oracle/quadric_march.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace reliefbake {

namespace {

using Imath::V2d;
using Imath::V3d;

constexpr double steps_per_texel = 2; ///< of the march; a bump that a ray is in for less may be overlooked
constexpr int least_steps = 64, most_steps = 4096, halvings = 40;
constexpr double nowhere = std::numeric_limits<double>::infinity();

V3d vector(const Vec3& v) { return {v[0], v[1], v[2]}; }
V2d down(const Mesh& mesh, std::uint32_t v) { return {double(mesh.uvs[v].x), mesh.v_down ? double(mesh.uvs[v].y) : 1 - double(mesh.uvs[v].y)}; }

/// What a fragment shader is given: the ray in the pixel's frame, and the map under it.
struct Pixel {
    V3d ray{0};         ///< unit, z < 0
    V2d uv{0};          ///< in maps
    V2d uv_x{0}, uv_y{0}; ///< change of uv per unit of x, y
    double a, b, c;
    double depth_scale;
    V2d ends{nowhere, nowhere}; ///< uv in maps where the map ends; the other end is 0
    V3d x{0}, y{0}, n{0}; ///< the frame
};

struct Place {
    double depth; ///< mesh units below the surface
    V2d uv;
};

Place place_at(const Pixel& pixel, BendModel model, double t) {
    const V3d p = pixel.ray * t;
    const auto beside = [&](double x, double y) { return pixel.uv + pixel.uv_x * x + pixel.uv_y * y; };
    switch (model) {
    case BendModel::flat: return {-p.z, beside(p.x, p.y)};
    case BendModel::ab: return {pixel.a * p.x * p.x + pixel.b * p.y * p.y - p.z, beside(p.x, p.y)};
    case BendModel::abc: return {pixel.a * p.x * p.x + pixel.b * p.y * p.y + pixel.c * p.x * p.y - p.z, beside(p.x, p.y)};
    case BendModel::circle: break;
    }
    const double across = std::hypot(pixel.ray.x, pixel.ray.y);
    if (across < 1e-9) return {-p.z, pixel.uv};
    const double x = pixel.ray.x / across, y = pixel.ray.y / across, s = across * t;
    const double k = -2 * (pixel.a * x * x + pixel.b * y * y + pixel.c * x * y), w = k * (s * s + p.z * p.z) + 2 * p.z;
    const double inside = 1 + k * w; // square of the distance from the circle's centre, in radii
    const double depth = -w / (1 + std::sqrt(std::max(inside, 0.0)));
    const double arc = std::fabs(k * s) < 1e-9 ? s : std::atan2(k * s, 1 + k * p.z) / k;
    return {depth, beside(arc * x, arc * y)};
}

/// Where the ray has come to the floor or back to the surface, at the latest; the march ends earlier if it can. Beyond `reach` it is lost.
double last_t(const Pixel& pixel, BendModel model, double reach) {
    double high = std::min(reach, pixel.depth_scale / std::max(-pixel.ray.z, 1e-9));
    if (model == BendModel::flat) return high;
    const V3d& v = pixel.ray;
    const double q = pixel.a * v.x * v.x + pixel.b * v.y * v.y + (model == BendModel::ab ? 0 : pixel.c * v.x * v.y);
    // A ray over a surface that falls away goes on for longer than over a plane, until it leaves: twice as far as it is deepest.
    return q < 0 ? std::min(reach, std::max(high, 2 * v.z / q)) : high;
}

bool is_beyond(const Pixel& pixel, const V2d& uv) {
    return (pixel.ends.x < nowhere && (uv.x < 0 || uv.x > pixel.ends.x)) || (pixel.ends.y < nowhere && (uv.y < 0 || uv.y > pixel.ends.y));
}

/// The surface's normal where the ray is at t, not unit, in the pixel's frame.
V3d base_normal(const Pixel& pixel, BendModel model, double t) {
    const V3d p = pixel.ray * t;
    if (model == BendModel::flat) return {0, 0, 1};
    const double c = model == BendModel::ab ? 0 : pixel.c;
    if (model != BendModel::circle) return {-2 * pixel.a * p.x - c * p.y, -2 * pixel.b * p.y - c * p.x, 1};
    const double across = std::max(std::hypot(pixel.ray.x, pixel.ray.y), 1e-9), x = pixel.ray.x / across, y = pixel.ray.y / across;
    const double k = -2 * (pixel.a * x * x + pixel.b * y * y + c * x * y);
    return {k * p.x, k * p.y, 1 + k * p.z};
}

/// Unit normal of the relief at a hit, in the mesh's space.
V3d relief_normal(const Pixel& pixel, const BilinearSurface& relief, BendModel model, double t) {
    const V2d uv = place_at(pixel, model, t).uv;
    const double px = relief.to_x(uv.x), py = relief.to_y(uv.y), i = std::floor(px), j = std::floor(py);
    const Patch patch = relief.patch(std::int64_t(i), std::int64_t(j));
    const V2d slope(patch.slope(px - i, py - j, 1, 0) * relief.grid().width, patch.slope(px - i, py - j, 0, 1) * relief.grid().height);
    const V3d up = base_normal(pixel, model, t).normalized();
    const V3d x = (V3d(1, 0, 0) - up * up.x).normalized(), y = up.cross(x);
    const V3d n = up - (x * slope.dot(pixel.uv_x) + y * slope.dot(pixel.uv_y)) * pixel.depth_scale;
    return (pixel.x * n.x + pixel.y * n.y + pixel.n * n.z).normalized();
}

std::optional<double> first_hit(const Pixel& pixel, const BilinearSurface& relief, BendModel model, double reach) {
    const auto gap = [&](const Place& p) { return p.depth - pixel.depth_scale * (1 - relief.height(p.uv.x, p.uv.y)); };
    const double end = last_t(pixel, model, reach);
    const V2d along = pixel.uv_x * pixel.ray.x + pixel.uv_y * pixel.ray.y;
    const double texels = end * std::hypot(along.x * relief.grid().width, along.y * relief.grid().height);
    const int steps = int(std::clamp(steps_per_texel * texels, double(least_steps), double(most_steps)));
    if (gap({0, pixel.uv}) >= 0) return 0;
    for (int i = 1; i <= steps; ++i) {
        double high = end * i / steps, low = end * (i - 1) / steps;
        const Place place = place_at(pixel, model, high);
        if (gap(place) < 0) {
            if (place.depth < 0 || is_beyond(pixel, place.uv)) return {};
            continue;
        }
        for (int k = 0; k < halvings; ++k) {
            const double middle = (low + high) / 2;
            (gap(place_at(pixel, model, middle)) >= 0 ? high : low) = middle;
        }
        return is_beyond(pixel, place_at(pixel, model, high).uv) ? std::nullopt : std::optional(high);
    }
    return {};
}

/// Screen positions, x right and y down in pixels.
class Screen {
  public:
    Screen(const Camera& camera, int width, int height)
        : forward_(vector(camera.forward)), right_(vector(camera.right)), up_(vector(camera.up)), width_(width), height_(height) {}

    V2d project(const V3d& p) const {
        const double ahead = p.dot(forward_);
        return {(p.dot(right_) / right_.length2() / ahead + 1) / 2 * width_, (1 - p.dot(up_) / up_.length2() / ahead) / 2 * height_};
    }
    V3d sight(int x, int y) const { return (forward_ + right_ * (2 * (x + 0.5) / width_ - 1) + up_ * (1 - 2 * (y + 0.5) / height_)).normalized(); }
    bool ahead(const V3d& p) const { return p.dot(forward_) > 0; }

  private:
    V3d forward_, right_, up_;
    double width_, height_;
};

/// One triangle as it is set up for a picture.
class Fragments {
  public:
    Fragments(const Mesh& mesh, const MeshRelief& how, const Triangle& t, const Camera& camera, const QuadricMarchOptions& options)
        : mesh_(mesh), how_(how), options_(options), t_(t) {
        eye_ = vector(camera.eye);
        for (std::size_t k = 0; k < 3; ++k) corner_[k] = mesh.positions[t[k]] - eye_;
        normal_ = (corner_[1] - corner_[0]).cross(corner_[2] - corner_[0]);
        // Change of uv along the triangle: uv = uv0 + e (gradient), e in its plane.
        const V2d p = map_uv(1) - map_uv(0), q = map_uv(2) - map_uv(0);
        const V3d s = corner_[1] - corner_[0], r = corner_[2] - corner_[0];
        const double area = normal_.length2();
        if (area > 0) {
            const V3d ds = r.cross(normal_) / area, dr = normal_.cross(s) / area; // dual basis
            gradient_u_ = ds * p.x + dr * q.x;
            gradient_v_ = ds * p.y + dr * q.y;
        }
    }

    /// Distance of the triangle along a sight from the eye; nothing if it is missed or seen from behind.
    std::optional<std::array<double, 3>> weights(const V3d& sight, double& distance) const {
        if (!(normal_.dot(sight) < 0)) return {};
        distance = normal_.dot(corner_[0]) / normal_.dot(sight);
        const V3d p = sight * distance;
        std::array<double, 3> w;
        for (std::size_t k = 0; k < 3; ++k) {
            const V3d &a = corner_[(k + 1) % 3], &b = corner_[(k + 2) % 3];
            w[k] = normal_.dot((b - a).cross(p - a)) / normal_.length2();
            if (w[k] < 0) return {};
        }
        return w;
    }

    Pixel pixel(const std::array<double, 3>& w, const V3d& sight) const {
        V3d n(0), x(0);
        Pixel result{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = t_[k];
            const Imath::V4f& tangent = mesh_.tangents[v];
            n += V3d(mesh_.normals[v]) * w[k];
            x += V3d(tangent.x, tangent.y, tangent.z) * w[k];
            result.uv += map_uv(k) * w[k];
            const Quadric& q = mesh_.quadrics[v];
            result.a += q.a * w[k], result.b += q.b * w[k], result.c += q.c * w[k];
        }
        n.normalize();
        x = (x - n * n.dot(x)).normalized();
        const V3d y = n.cross(x) * double(mesh_.tangents[t_[0]].w);
        result.ray = {sight.dot(x), sight.dot(y), sight.dot(n)};
        result.uv_x = {gradient_u_.dot(x), gradient_v_.dot(x)};
        result.uv_y = {gradient_u_.dot(y), gradient_v_.dot(y)};
        result.depth_scale = how_.depth_scale;
        result.x = x, result.y = y, result.n = n;
        if (options_.ends_u) result.ends.x = how_.tiles_u;
        if (options_.ends_v) result.ends.y = how_.tiles_v;
        return result;
    }

    /// The pixels it can cover; none for one that reaches behind the eye.
    std::optional<std::pair<V2d, V2d>> box(const Screen& screen) const {
        V2d least(nowhere), most(-nowhere);
        for (const V3d& corner : corner_) {
            if (!screen.ahead(corner)) return {};
            const V2d p = screen.project(corner);
            least = {std::min(least.x, p.x), std::min(least.y, p.y)};
            most = {std::max(most.x, p.x), std::max(most.y, p.y)};
        }
        return std::pair(least, most);
    }

  private:
    V2d map_uv(std::size_t k) const {
        const V2d uv = down(mesh_, t_[k]);
        return {uv.x * how_.tiles_u, uv.y * how_.tiles_v};
    }

    const Mesh& mesh_;
    const MeshRelief& how_;
    const QuadricMarchOptions& options_;
    Triangle t_;
    V3d eye_, normal_, gradient_u_{0}, gradient_v_{0};
    std::array<V3d, 3> corner_;
};

} // namespace

QuadricMarch march_quadrics(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const Camera& camera,
                            const QuadricMarchOptions& options) {
    constexpr int band = 8; // rows of one task
    const int width = options.width, height = options.height;
    const Screen screen(camera, width, height);
    QuadricMarch march{Image<float>(width, height, std::numeric_limits<float>::infinity()), {}};
    march.normal.assign(march.distance.size(), Imath::V3f(0));
    std::vector<Fragments> triangles;
    V3d low(nowhere), high(-nowhere);
    for (const Triangle& t : mesh.triangles) triangles.emplace_back(mesh, how, t, camera, options);
    for (const V3d& p : mesh.positions)
        for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    const double reach = (high - low).length();
    const auto shade = [&](const Fragments& triangle, int x, int y) {
        const V3d sight = screen.sight(x, y);
        double distance = 0;
        float& nearest = march.distance(x, y);
        const auto w = triangle.weights(sight, distance);
        if (!w || distance >= nearest) return;
        const Pixel pixel = triangle.pixel(*w, sight);
        const auto hit = first_hit(pixel, relief, options.model, reach);
        if (!hit || distance + *hit >= nearest) return;
        nearest = float(distance + *hit);
        march.normal[std::size_t(y) * std::size_t(width) + std::size_t(x)] = Imath::V3f(relief_normal(pixel, relief, options.model, *hit));
    };
    parallel_for((height + band - 1) / band, options.threads, [&](int task) {
        const int first = task * band, last = std::min(height, first + band) - 1;
        for (const Fragments& triangle : triangles) {
            const auto box = triangle.box(screen);
            if (!box) continue;
            const auto& [least, most] = *box;
            for (int y = std::max(first, int(std::floor(least.y))); y <= std::min(last, int(most.y)); ++y)
                for (int x = std::max(0, int(std::floor(least.x))); x <= std::min(width - 1, int(most.x)); ++x) shade(triangle, x, y);
        }
    });
    return march;
}

} // namespace reliefbake

#include "shaders-reference/measure/verify_mesh.h"

#include "shaders-reference/renderer/resolve.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace reliefbake {

namespace {

using Imath::V3d;

RgbImage difference_picture(const MeshPlanes& planes, double depth_scale) {
    using Rgb = std::array<std::uint8_t, 3>;
    RgbImage picture{planes.base.width(), planes.base.height(), {}};
    for (std::size_t k = 0; k < planes.base.size(); ++k) {
        const bool truth = std::isfinite(planes.truth[k]), rendering = std::isfinite(planes.rendering[k]);
        Rgb colour{24, 25, 28};
        if (truth && rendering) {
            const double error = std::fabs(double(planes.truth[k]) - double(planes.rendering[k])) / depth_scale;
            colour.fill(std::uint8_t(std::lround(200 * (1 - std::min(1.0, 2 * error)))));
        } else if (truth) colour = {222, 45, 38};
        else if (rendering) colour = {49, 100, 222};
        else if (std::isfinite(planes.base[k])) colour = {150, 200, 150};
        picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
    }
    return picture;
}

nlohmann::json numbers_of(const MeshComparison& c) {
    return {{"iou", c.iou()},
            {"band_agreement", c.band_agreement()},
            {"cut_iou", c.cut_iou()},
            {"holes", c.holes},
            {"wrong_cover", c.wrong_cover},
            {"not_finite", c.not_finite},
            {"base", c.base},
            {"truth", c.truth},
            {"rendering", c.rendering},
            {"band", c.band},
            {"depth_mean", c.depth_mean},
            {"depth_99", c.depth_99},
            {"depth_max", c.depth_max},
            {"steps_mean", c.steps_mean},
            {"steps_max", c.steps_max}};
}

/// Clay as in glsl/light.glsl.
Quad clay(const Imath::V3f& normal, const Vec3& light) {
    constexpr float sun_colour[] = {2.75f, 2.3f, 1.75f}, sky[] = {0.34f, 0.46f, 0.68f}, bounce[] = {0.26f, 0.18f, 0.12f}, base[] = {0.62f, 0.44f, 0.31f};
    const float lit = std::max(0.0f, float(normal.x * light[0] + normal.y * light[1] + normal.z * light[2])), up = 0.5f + 0.5f * normal.z;
    Quad colour{0, 0, 0, 1};
    for (std::size_t k = 0; k < 3; ++k) {
        const float x = 0.62f * base[k] * (sun_colour[k] * lit + bounce[k] + (sky[k] - bounce[k]) * up);
        colour[k] = std::clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
    }
    return colour;
}

} // namespace

MeshShader marching_shader(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const QuadricMarchOptions& options) {
    return [&](const View& view, const Camera& camera) -> Result<MeshFrame> {
        const auto start = std::chrono::steady_clock::now();
        QuadricMarch march = march_quadrics(mesh, relief, how, camera, options);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        Image<Quad> linear(options.width, options.height, Quad{});
        const Vec3 light = mesh_sun(view);
        for (std::size_t k = 0; k < linear.size(); ++k)
            if (std::isfinite(march.distance[k])) linear[k] = clay(march.normal[k], light);
        return MeshFrame{std::move(march.distance), Image<float>(options.width, options.height, 0), resolve_picture(linear, 1), seconds};
    };
}

Vec3 mesh_sun(const View& view) { return sun_direction({-130, 35}, view); }

Ball ball_around(const Mesh& mesh) {
    V3d low(std::numeric_limits<double>::infinity()), high(-std::numeric_limits<double>::infinity());
    for (const V3d& p : mesh.positions) {
        if (!std::isfinite(p.x + p.y + p.z)) continue;
        for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    const V3d middle = (low + high) / 2.0;
    double radius = 0;
    for (const V3d& p : mesh.positions)
        if (std::isfinite(p.x + p.y + p.z)) radius = std::max(radius, (p - middle).length());
    return {{middle.x, middle.y, middle.z}, radius > 0 ? radius : 1};
}

Result<MeshVerifyReport> verify_mesh(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const MeshShader& shader,
                                     const MeshVerifyOptions& options) {
    if (mesh.uvs.empty() || mesh.normals.empty())
        return fail(ErrorCode::usage, "the mesh has no texture coordinates or no normals; there is no place for a relief on it");
    Result<PlainMeshRenderer> renderer = PlainMeshRenderer::create(options.backend);
    if (!renderer) return tl::unexpected<Error>(renderer.error());
    const Ball ball = ball_around(mesh);
    MeshVerifyReport report;
    report.depth_scale = how.depth_scale;
    std::vector<MeshPlanes> all;
    for (const View& view : options.views) {
        PlainMeshOptions frame;
        frame.width = options.width;
        frame.height = options.height;
        frame.camera = make_orbit_camera(ball.middle, ball.radius, view, double(options.width) / options.height);
        frame.sun = mesh_sun(view);
        Result<PlainMeshRendering> base = renderer->render(frame, plain_triangles(mesh));
        if (!base) return tl::unexpected<Error>(base.error());
        Result<PlainMeshRendering> truth = renderer->render(frame, displaced_triangles(mesh, relief, how));
        if (!truth) return tl::unexpected<Error>(truth.error());
        Result<MeshFrame> shaded = shader(view, frame.camera);
        if (!shaded) return tl::unexpected<Error>(shaded.error());
        all.push_back({std::move(base->distance), std::move(truth->distance), std::move(shaded->distance), std::move(shaded->steps)});

        MeshViewReport entry{view, compare_mesh({&all.back(), 1}, how.depth_scale), 1000 * shaded->seconds, {}};
        if (options.pictures)
            entry.pictures = MeshViewPictures{std::move(shaded->colour), std::move(truth->colour), difference_picture(all.back(), how.depth_scale)};
        report.views.push_back(std::move(entry));
    }
    report.total = compare_mesh(all, how.depth_scale);
    return report;
}

nlohmann::json to_json(const MeshVerifyReport& report) {
    nlohmann::json json = numbers_of(report.total);
    json["depth_scale"] = report.depth_scale;
    double milliseconds = 0;
    for (const MeshViewReport& entry : report.views) {
        nlohmann::json view = numbers_of(entry.comparison);
        view["angle"] = entry.view.angle;
        view["azimuth"] = entry.view.azimuth;
        view["milliseconds"] = entry.milliseconds;
        json["views"].push_back(std::move(view));
        milliseconds += entry.milliseconds;
    }
    json["milliseconds"] = milliseconds;
    return json;
}

} // namespace reliefbake

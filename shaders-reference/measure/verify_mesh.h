#pragma once
// The whole judgement of curved relief on one mesh: views of the shader's frames beside the mesh really displaced.

#include "shaders-reference/measure/compare_mesh.h"
#include "shaders-reference/oracle/quadric_march.h"
#include "shaders-reference/renderer/plain_mesh.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// What a shader makes of one view of a mesh; one sample a pixel, the top row first.
struct MeshFrame {
    Image<float> distance; ///< from the eye to the relief; +inf where nothing is drawn, NaN where a result is not finite
    Image<float> steps;    ///< of the march, where the mesh was
    RgbImage colour;
    double seconds = 0;    ///< drawing
};
using MeshShader = std::function<Result<MeshFrame>(const View& view, const Camera& camera)>;

/// The march without limits (oracle/quadric_march.h) as a shader. Mesh, relief and options outlive the result.
MeshShader marching_shader(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const QuadricMarchOptions& options);

struct MeshVerifyOptions {
    RendererBackend backend = RendererBackend::osmesa; ///< (--renderer)
    int width = 1024, height = 768; ///< pixels of each view (--size)
    std::vector<View> views{{90, 20, 30, 0}, {75, 140, 30, 0}, {60, 260, 30, 0}}; ///< angle from the z axis, azimuth, field; the mesh fills the picture (--mesh-view)
    bool pictures = false; ///< keep pictures of every view (--pictures)
};

struct MeshViewPictures {
    RgbImage rendering, truth;
    /// Grey: both cover, darker where depths part, black from half the depth scale on; pale green: both leave bare what the mesh covers;
    /// red: holes; blue: wrong cover.
    RgbImage difference;
};

struct MeshViewReport {
    View view;
    MeshComparison comparison;
    double milliseconds = 0; ///< of the shader's frame
    std::optional<MeshViewPictures> pictures;
};

struct MeshVerifyReport {
    double depth_scale = 0;      ///< unit of the depth errors
    MeshComparison total;
    std::vector<MeshViewReport> views;
};

/// Towards the light of a view: from behind the viewer's left shoulder.
Vec3 mesh_sun(const View& view);

/// A ball that holds the mesh's finite positions: middle and radius, > 0.
struct Ball {
    Vec3 middle;
    double radius;
};
Ball ball_around(const Mesh& mesh);

/// Errors: the shader's; (usage) no renderer, a mesh without texture coordinates; (budget) too many triangles.
Result<MeshVerifyReport> verify_mesh(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const MeshShader& shader,
                                     const MeshVerifyOptions& options = {});

/// Keys: depth_scale, iou, band_agreement, cut_iou, holes, wrong_cover, not_finite, base, truth, rendering, band (pixels), depth_mean,
/// depth_99, depth_max (depth scales), steps_mean, steps_max, milliseconds, views: angle, azimuth and the same.
nlohmann::json to_json(const MeshVerifyReport& report);

} // namespace reliefbake

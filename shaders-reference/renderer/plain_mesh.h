#pragma once
// Rasterises triangles as they are: a mesh without relief, or one really displaced.

#include "bake/error.h"
#include "shaders-reference/oracle/displaced_mesh.h"
#include "shaders-reference/renderer/gl_context.h"
#include "shaders-reference/renderer/rendering.h"
#include "shaders-reference/renderer/scene.h"

#include <functional>
#include <memory>

namespace reliefbake {

struct PlainMeshOptions {
    Camera camera;
    Vec3 sun{0, 0, 1};   ///< unit vector towards the light
    int width = 1024;    ///< of the picture, pixels
    int height = 768;
    int supersample = 1; ///< samples per pixel and axis
};

/// Planes of the samples, the top row first.
struct PlainMeshRendering {
    Image<float> distance; ///< from the eye along the line of sight; +inf where there is nothing
    RgbImage colour;
};

/// Gives all its triangles to the sink, batch by batch.
using TriangleSource = std::function<Result<void>(const TriangleSink&)>;

class PlainMeshRenderer {
  public:
    /// Errors (usage): the backend is not available; says what to install.
    static Result<PlainMeshRenderer> create(RendererBackend backend);

    PlainMeshRenderer(PlainMeshRenderer&&) noexcept;
    PlainMeshRenderer& operator=(PlainMeshRenderer&&) noexcept;
    ~PlainMeshRenderer();

    /// Draws front faces. Deterministic on one machine; of the triangles no more than a batch is held. Errors: the
    /// source's; (usage): a picture larger than the driver allows.
    Result<PlainMeshRendering> render(const PlainMeshOptions& options, const TriangleSource& triangles);

  private:
    struct State;
    explicit PlainMeshRenderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// The mesh's own triangles, with its normals. The mesh outlives the result.
TriangleSource plain_triangles(const Mesh& mesh);
/// The mesh displaced. Mesh and relief outlive the result.
TriangleSource displaced_triangles(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const DisplaceOptions& options = {});

} // namespace reliefbake

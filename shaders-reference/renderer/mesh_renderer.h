#pragma once
// Renders relief, or the extrusion of a shape, over curved meshes (000, 004; MATHS section 7).

#include "bake/error.h"
#include "bake/relief_map.h"
#include "bake/shape_map.h"
#include "mesh/mesh.h"
#include "shaders-reference/mesh_relief.h"
#include "shaders-reference/renderer/gl_context.h"
#include "shaders-reference/renderer/relief_renderer.h"
#include "shaders-reference/renderer/shape_texture.h"

#include <memory>
#include <vector>

namespace reliefbake {

/// How the march knows of the mesh's curvature.
enum class Correction {
    none, ///< not at all: every polygon is a plane, and nothing is cut away at the silhouette
    ray,  ///< the ray bends by the vertical distance to the quadric (000 Algorithms 3, 4; 004 Algorithms 3 to 6)
    cone, ///< the cone sinks with the quadric, the ray stays straight (000 Algorithms 5, 6); cone maps alone
    ray_published,  ///< both as printed, for comparison: what they do depends on the mesh's unit
    cone_published, ///< (000 Algorithms 1 to 7; 004 Algorithms 1 to 9)
    bent, ///< ours: the ray bends by the distance to a torus with the quadric's curvatures, and so do texture and normals
};

/// A mesh in the world, with what `reliefbake quadric` gave its vertices.
struct MeshObject {
    const Mesh* mesh = nullptr; ///< with unit normals, tangents and texture coordinates; with quadrics but for Correction::none
    MeshRelief relief;
    bool ends_u = false, ends_v = false; ///< the relief ends where the texture coordinate is 0 and 1, as the mesh does there (--ends)
};

struct MeshRenderOptions {
    Correction correction = Correction::bent; ///< (--correction)
    Technique technique = Technique::cone; ///< cone or relaxed: the map's cones; binary: linear search and halving (--technique)
    bool twist = true;         ///< c of the quadrics counts (--terms abc)
    int max_steps = 25;        ///< of cones and circles; 000, 004: 25 (--steps)
    int linear_steps = 25;     ///< of the linear search (--steps)
    int binary_steps = 5;      ///< halvings at the end; 000, 004: 5 (--binary-steps)
    float epsilon = 1.0f / 4096; ///< gap that counts as a hit, depths of the relief
    ShapeSolid solid;          ///< of shape maps: e, b and c
    int width = 1024;          ///< of the picture, pixels (--size)
    int height = 768;
    int supersample = 1;       ///< rays per pixel and axis (--supersample)
    Camera camera;
    Vec3 sun{0, 0, 1};         ///< unit vector towards the light
};

/// Planes of the samples, the top row first.
struct MeshRendering {
    Image<float> distance; ///< from the eye to the relief; +inf where nothing is drawn
    Image<float> steps;    ///< of the march; 0 where no mesh is
    Image<float> fetches;  ///< texture reads
    RgbImage colour;
    double seconds = 0;    ///< drawing, up to glFinish
};

class MeshRenderer {
  public:
    /// Errors (usage): the backend is not available; says what to install.
    static Result<MeshRenderer> create(RendererBackend backend);

    MeshRenderer(MeshRenderer&&) noexcept;
    MeshRenderer& operator=(MeshRenderer&&) noexcept;
    ~MeshRenderer();

    /// Uploads the map that following frames show. Errors (usage): larger than the driver's textures; no depth; several cones in pieces.
    Result<void> load(const ReliefMap& map);
    Result<void> load(const ShapeMap& map);
    /// Uploads the meshes. Errors (usage): one without normals, tangents or texture coordinates, or with more triangles than a buffer holds.
    Result<void> set_objects(const std::vector<MeshObject>& objects);

    /// Draws the front faces of all objects; they hide each other by the depth of their relief. Deterministic on one machine. Errors
    /// (usage): a picture larger than the driver allows; a technique or correction that map or meshes do not serve.
    Result<MeshRendering> render(const MeshRenderOptions& options);

  private:
    struct State;
    explicit MeshRenderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace reliefbake

#include "cli/render/render_mesh.h"

#include "cli/choices.h"
#include "formats/write_image.h"
#include "shaders-reference/measure/verify_mesh.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

const Words<bool> up_words = {{"z", false}, {"y", true}};

/// Turns what has y up about the x axis, so that z is.
void stand_up(Mesh& mesh) {
    for (Imath::V3d& p : mesh.positions) p = {p.x, -p.z, p.y};
    for (Imath::V3f& n : mesh.normals) n = {n.x, -n.z, n.y};
    for (Imath::V4f& t : mesh.tangents) t = {t.x, -t.z, t.y, t.w};
}

/// A ball around all of them, of the first one's middle.
Ball ball_around_all(const std::vector<Mesh>& meshes) {
    Ball ball = ball_around(meshes.front());
    for (const Mesh& mesh : meshes) {
        const Ball other = ball_around(mesh);
        const double apart = std::hypot(other.middle[0] - ball.middle[0], other.middle[1] - ball.middle[1], other.middle[2] - ball.middle[2]);
        ball.radius = std::max(ball.radius, apart + other.radius);
    }
    return ball;
}

} // namespace

void add_render_mesh_options(CLI::App& app, RenderMeshOptions& options) {
    app.option_defaults()->group(mesh_group);
    app.add_option("--mesh", options.files, "Lay the map on this mesh with quadrics (reliefbake quadric); several may be given. --depth-scale is in its unit")
        ->type_name("MESH")
        ->allow_extra_args(false);
    add_mesh_options(app, options.mesh);
    add_choice(app, "--up", options.y_up, up_words, "The meshes' axis that points up in the picture (default z)");
}

Result<void> render_on_meshes(const MeshPicture& given, const RenderMeshOptions& options, bool shape) {
    constexpr double default_depth = 0.1; // of the meshes' radius
    std::vector<Mesh> meshes;
    for (const std::string& file : options.files) {
        Result<Mesh> mesh = read_framed_mesh(file, options.mesh.correction);
        if (!mesh) return tl::unexpected(mesh.error());
        if (options.y_up) stand_up(*mesh);
        meshes.push_back(std::move(*mesh));
    }
    const Ball ball = ball_around_all(meshes);
    const double depth_scale = given.solid.depth_scale.value_or(default_depth * ball.radius);
    std::vector<MeshObject> objects;
    for (const Mesh& mesh : meshes) objects.push_back(mesh_object(mesh, options.mesh, depth_scale));

    Result<MeshRenderer> renderer = MeshRenderer::create(given.backend);
    if (!renderer) return tl::unexpected(renderer.error());
    Result<LoadedMap> map = load_mesh_map(&*renderer, given.file, given.hints, shape, options.mesh, given.technique, given.solid);
    if (!map) return tl::unexpected(map.error());
    if (Result<void> set = renderer->set_objects(objects); !set) return set;
    MeshRenderOptions& picture = map->picture;
    picture.width = given.picture.width, picture.height = given.picture.height;
    picture.supersample = given.picture.supersample;
    picture.camera = make_orbit_camera(ball.middle, ball.radius, given.picture.view, double(picture.width) / picture.height);
    picture.sun = sun_direction(given.picture.sun, given.picture.view);
    const Result<MeshRendering> rendering = renderer->render(picture);
    if (!rendering) return fail(rendering.error().code, given.file + ": " + rendering.error().message);
    return write_png(given.output, rendering->colour.width, rendering->colour.height, 3, rendering->colour.rgb);
}

} // namespace reliefbake

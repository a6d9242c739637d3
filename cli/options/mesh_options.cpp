#include "cli/options/mesh_options.h"

#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "formats/mesh_file.h"
#include "formats/shape_file.h"
#include "shaders-reference/measure/shape_relief.h"
#include "shaders-reference/measure/stored_depth.h"

namespace reliefbake {

namespace {

const Words<Correction> correction_words = {{"none", Correction::none}, {"ray", Correction::ray}, {"cone", Correction::cone},
                                            {"ray-published", Correction::ray_published}, {"cone-published", Correction::cone_published}, {"bent", Correction::bent}};
const Words<bool> terms_words = {{"ab", false}, {"abc", true}};
const Words<std::string> ends_words = {{"u", "u"}, {"v", "v"}, {"uv", "uv"}};

} // namespace

void add_mesh_options(CLI::App& app, MeshOptions& options) {
    const auto tiles = [&options](const std::string& text) { options.tiles = require_repeats("--mesh-tiles", text); };
    app.add_option_function<std::string>("--mesh-tiles", tiles, "Repeats of the map over the mesh's texture coordinates (default 1)")->type_name("N[,M]");
    add_choice(app, "--correction", options.correction, correction_words, "How a ray knows of the mesh's curvature (default bent)");
    add_choice(app, "--terms", options.twist, terms_words, "Terms of the quadrics that count (default abc)");
    add_choice(app, "--ends", options.ends, ends_words, "Axes on which the map ends with the mesh, at texture coordinates 0 and 1 (default none)");
}

Result<Mesh> read_framed_mesh(const std::string& file, Correction correction) {
    Result<MeshFile> read = read_mesh(file);
    if (!read) return tl::unexpected(read.error());
    if (read->meshes.size() != 1)
        return fail(ErrorCode::usage, file + ": expected one mesh, found " + std::to_string(read->meshes.size()) + "; give a file that holds one");
    Mesh mesh = std::move(read->meshes[0]);
    if (mesh.uvs.empty()) return fail(ErrorCode::usage, file + ": has no texture coordinates; there is no place for a relief on it");
    const bool framed = !mesh.normals.empty() && !mesh.tangents.empty();
    if (!framed || (mesh.quadrics.empty() && correction != Correction::none))
        return fail(ErrorCode::usage, file + ": has no " + (framed ? "quadrics" : "normals and tangents") + "; bake them first (reliefbake quadric " + file + " -o OUT.glb)");
    return mesh;
}

MeshObject mesh_object(const Mesh& mesh, const MeshOptions& options, double depth_scale) {
    return {&mesh, {depth_scale, options.tiles.first, options.tiles.second}, options.ends_u(), options.ends_v()};
}

namespace {

MeshRenderOptions mesh_picture(const MeshOptions& options, const TechniqueOptions& technique) {
    MeshRenderOptions picture;
    picture.correction = options.correction;
    picture.twist = options.twist;
    picture.max_steps = technique.steps.value_or(picture.max_steps);
    picture.linear_steps = technique.steps.value_or(picture.linear_steps);
    picture.binary_steps = technique.binary_steps.value_or(picture.binary_steps);
    return picture;
}

Result<LoadedMap> load_shape(MeshRenderer* renderer, const std::string& file, const MapHints& hints, MeshRenderOptions picture, const SolidOptions& given) {
    const Result<ShapeSolid> solid = resolve_solid(given);
    if (!solid) return tl::unexpected(solid.error());
    const Result<ShapeMap> map = read_shape_map(file, hints.max_bytes);
    if (!map) return tl::unexpected(map.error());
    if (renderer)
        if (Result<void> loaded = renderer->load(*map); !loaded) return tl::unexpected(loaded.error());
    picture.solid = *solid;
    return LoadedMap{shape_relief(*map, *solid), picture};
}

} // namespace

Result<LoadedMap> load_mesh_map(MeshRenderer* renderer, const std::string& file, const MapHints& hints, bool shape, const MeshOptions& options,
                                const TechniqueOptions& technique, const SolidOptions& solid) {
    if (technique.exact_finish) return fail(ErrorCode::usage, "--exact-finish: is for planes");
    MeshRenderOptions picture = mesh_picture(options, technique);
    if (shape) return load_shape(renderer, file, hints, picture, solid);
    const Result<ReliefMap> map = read_map(file, hints);
    if (!map) return tl::unexpected(map.error());
    if (map->depth.empty()) return fail(ErrorCode::usage, file + ": has no depth channel: there is no relief on a mesh");
    if (renderer)
        if (Result<void> loaded = renderer->load(*map); !loaded) return tl::unexpected(loaded.error());
    picture.technique = technique.technique.value_or(!has_cones(*map) ? Technique::binary : suitable_technique(*map));
    return LoadedMap{stored_depth(*map), picture};
}

} // namespace reliefbake

#include "cli/verify/verify_mesh.h"

#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "cli/verify/verify_text.h"
#include "formats/write_image.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <tuple>

namespace reliefbake {

namespace {

const Words<BendModel> bend_words = {{"flat", BendModel::flat}, {"ab", BendModel::ab}, {"abc", BendModel::abc}, {"circle", BendModel::circle}};

/// FOLDER/mesh-ANGLE-AZIMUTH-{rendering,truth,difference}.png
Result<void> write_pictures(const std::string& folder, const MeshVerifyReport& report) {
    for (const MeshViewReport& view : report.views) {
        char stem[64];
        std::snprintf(stem, sizeof stem, "mesh-%02.0f-%03.0f-", view.view.angle, view.view.azimuth);
        const std::pair<const char*, const RgbImage&> pictures[] = {{"rendering", view.pictures->rendering},
                                                                    {"truth", view.pictures->truth},
                                                                    {"difference", view.pictures->difference}};
        for (const auto& [name, picture] : pictures) {
            const std::filesystem::path path = std::filesystem::path(folder) / (std::string(stem) + name + ".png");
            Result<void> written = write_png(path, picture.width, picture.height, 3, picture.rgb);
            if (!written) return written;
        }
    }
    return {};
}

/// "ANGLE,AZIMUTH" in degrees.
View require_view(const std::string& text) {
    static const NumberRule angle = {[](double x) { return x >= 0 && x <= 180; }, "ANGLE,AZIMUTH: an angle from 0 to 180 degrees"};
    static const NumberRule azimuth = {[](double x) { return x >= -360 && x <= 360; }, "ANGLE,AZIMUTH: an azimuth from -360 to 360 degrees"};
    const std::size_t comma = std::min(text.find(','), text.size());
    View view;
    view.angle = require_number("--mesh-view", text.substr(0, comma), angle);
    view.azimuth = require_number("--mesh-view", comma < text.size() ? text.substr(comma + 1) : "", azimuth);
    return view;
}

Result<void> judge(const std::string& file, const MeshVerifyReport& report, const VerifyMeshOptions& given) {
    const auto below = [&](const char* what, double found, const std::optional<double>& least) -> Result<void> {
        if (!least || found >= *least) return {};
        return fail(ErrorCode::verification, file + ": " + what + " is " + std::to_string(found) + ", below the " + std::to_string(*least) + " asked for");
    };
    return below("the silhouette's IoU", report.total.iou(), given.least_iou).and_then([&] {
        return below("the agreement in the silhouette band", report.total.band_agreement(), given.least_band);
    });
}

} // namespace

void add_verify_mesh_options(CLI::App& app, VerifyMeshOptions& options) {
    app.option_defaults()->group(mesh_group);
    app.add_option("--mesh", options.file, "Judge the map on this mesh with quadrics, beside the mesh really displaced; --depth-scale in the mesh's unit")
        ->type_name("MESH");
    add_mesh_options(app, options.mesh);
    add_choice(app, "--ideal", options.ideal, bend_words, "Instead of the shader: a march without limits over this model of the surface, to tell its errors from the shader's");
    const auto view = [&options](const std::string& text) { options.views.push_back(require_view(text)); };
    app.add_option_function<std::string>("--mesh-view", view, "A view: degrees from the z axis, azimuth; several may be given (default three around it, from 90 to 60)")
        ->type_name("A,B")
        ->trigger_on_parse()
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    const auto size = [&options](const std::string& text) { options.size = require_size("--size", text); };
    app.add_option_function<std::string>("--size", size, "Pixels of each view (default 1024x768)")->type_name("WxH");
    add_number(app, "--least-iou", options.least_iou, fraction_number, "Exit with 4 when the silhouette's IoU is less");
    add_number(app, "--least-band", options.least_band, fraction_number, "Exit with 4 when less of the silhouette band agrees");
}

namespace {

Result<MeshVerifyReport> judge_ideal(const MeshJudgement& given, const BilinearSurface& relief, const Mesh& mesh, const MeshRelief& how, const MeshVerifyOptions& options) {
    QuadricMarchOptions march;
    march.model = *given.mesh.ideal;
    march.ends_u = given.mesh.mesh.ends_u(), march.ends_v = given.mesh.mesh.ends_v();
    march.width = options.width, march.height = options.height;
    march.threads = given.threads;
    return verify_mesh(mesh, relief, how, marching_shader(mesh, relief, how, march), options);
}

/// By the reference shader, as the options have it.
Result<MeshVerifyReport> judge_frames(const MeshJudgement& given, MeshRenderer& renderer, const LoadedMap& map, const Mesh& mesh, const MeshObject& object,
                                      const MeshVerifyOptions& options) {
    if (Result<void> set = renderer.set_objects({object}); !set) return tl::unexpected(set.error());
    MeshRenderOptions picture = map.picture;
    std::tie(picture.width, picture.height) = given.mesh.size;
    const auto shader = [&](const View& view, const Camera& camera) -> Result<MeshFrame> {
        picture.camera = camera;
        picture.sun = mesh_sun(view);
        Result<MeshRendering> frame = renderer.render(picture);
        if (!frame) return tl::unexpected(frame.error());
        return MeshFrame{std::move(frame->distance), std::move(frame->steps), std::move(frame->colour), frame->seconds};
    };
    return verify_mesh(mesh, BilinearSurface(map.relief), object.relief, shader, options);
}

} // namespace

Result<void> verify_on_mesh(const MeshJudgement& given) {
    constexpr double default_depth = 0.1; // of the mesh's radius
    const Result<Mesh> mesh = read_framed_mesh(given.mesh.file, given.mesh.mesh.correction);
    if (!mesh) return tl::unexpected(mesh.error());
    Result<MeshRenderer> renderer = MeshRenderer::create(given.backend);
    if (!renderer) return tl::unexpected(renderer.error());
    const Result<LoadedMap> map = load_mesh_map(given.mesh.ideal ? nullptr : &*renderer, given.file, given.hints, given.shape, given.mesh.mesh, given.technique, given.solid);
    if (!map) return tl::unexpected(map.error());
    const MeshObject object = mesh_object(*mesh, given.mesh.mesh, given.solid.depth_scale.value_or(default_depth * ball_around(*mesh).radius));
    MeshVerifyOptions options;
    options.backend = given.backend;
    std::tie(options.width, options.height) = given.mesh.size;
    if (!given.mesh.views.empty()) options.views = given.mesh.views;
    options.pictures = !given.pictures.empty();
    const Result<MeshVerifyReport> report = given.mesh.ideal ? judge_ideal(given, BilinearSurface(map->relief), *mesh, object.relief, options)
                                                             : judge_frames(given, *renderer, *map, *mesh, object, options);
    if (!report) return fail(report.error().code, given.mesh.file + ": " + report.error().message);
    std::fputs((given.json ? to_json(*report).dump(2) + "\n" : verify_text(*report)).c_str(), stdout);
    if (!given.pictures.empty())
        if (Result<void> written = write_pictures(given.pictures, *report); !written) return written;
    return judge(given.file, *report, given.mesh);
}

} // namespace reliefbake

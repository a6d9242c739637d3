#include "cli/bench/bench_surface.h"

#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "formats/mesh_file.h"
#include "mesh/quadric_bake.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace reliefbake {

namespace {

const Words<RevolvedSurface>& revolved_words() {
    static const Words<RevolvedSurface> words = [] {
        Words<RevolvedSurface> all;
        for (const RevolvedSurface& surface : revolved_surfaces()) all.emplace_back(surface.name, surface);
        return all;
    }();
    return words;
}

} // namespace

void BenchSurfaceCommand::add_to(CLI::App& app) {
    add_choice(app, "NAME", surface_, revolved_words(), "Which surface of revolution")->required();
    app.add_option("--segments", segments_, "Edges around its axis (default 64)")->check(CLI::Range(3, 4096));
    app.add_option("--shear", shear_, "Adds this to v on the way around: frames that lie across the curvatures (default 0)")->check(CLI::Range(-8, 8));
    add_number(app, "--scale", scale_, positive_number, "Units of the mesh for one of the surface (default 1)");
    app.add_option("-o,--output", output_, "Mesh to write, with quadrics: .glb, .gltf or .ply")->required()->type_name("OUT");
    app.add_flag("--json", json_, "Print one object");
}

Result<void> BenchSurfaceCommand::run() {
    if (Result<void> fits = check_mesh_output(output_, {}); !fits) return fits;
    Mesh mesh = make_revolved(surface_, segments_, shear_);
    for (Imath::V3d& p : mesh.positions) p *= scale_;
    const Result<QuadricBake> bake = bake_quadrics(mesh, {}, surface_.name);
    if (!bake) return tl::unexpected(bake.error());
    const nlohmann::json report{{"surface", surface_.name}, {"segments", segments_}, {"radius", surface_.radius * scale_}, {"triangles", bake->mesh.triangles.size()}};
    if (Result<void> written = write_mesh(output_, {MeshFormat::ply, {}, {}, {}}, {bake->mesh}, {bake->source}, {}, report); !written) return written;
    if (json_) std::printf("%s\n", report.dump(2).c_str());
    else std::printf("%s: %s, %zu triangles, radius %g\n", output_.c_str(), surface_.name.c_str(), bake->mesh.triangles.size(), surface_.radius * scale_);
    return {};
}

} // namespace reliefbake

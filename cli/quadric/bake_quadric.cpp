#include "cli/quadric/bake_quadric.h"

#include "cli/command_output.h"
#include "cli/quadric/quadric_report.h"
#include "cli/stage_clock.h"
#include "formats/write_image.h"
#include "shaders-reference/measure/curvature_picture.h"

#include <utility>

namespace reliefbake {

namespace {

Result<std::vector<QuadricBake>> bake_all(const QuadricCommandOptions& plan, const MeshFile& file) {
    std::vector<QuadricBake> bakes;
    for (const Mesh& mesh : file.meshes) {
        Result<QuadricBake> bake = bake_quadrics(mesh, plan.quadric, plan.input);
        if (!bake) return tl::unexpected(bake.error());
        bakes.push_back(std::move(*bake));
    }
    return bakes;
}

Result<void> write_preview(const QuadricCommandOptions& plan, const std::vector<Mesh>& meshes) {
    if (plan.preview.empty()) return {};
    constexpr int side = 600;
    const RgbImage picture = curvature_picture(meshes, side);
    return write_png(plan.preview, picture.width, picture.height, 3, picture.rgb);
}

Result<void> write_all(const QuadricCommandOptions& plan, const MeshFile& file, const std::vector<QuadricBake>& bakes) {
    std::vector<Mesh> meshes;
    std::vector<std::vector<std::uint32_t>> sources;
    for (const QuadricBake& bake : bakes) meshes.push_back(bake.mesh), sources.push_back(bake.source);
    return write_mesh(plan.output, file, meshes, sources, plan.store, quadric_info(plan, bakes)).and_then([&] { return write_preview(plan, meshes); });
}

} // namespace

void QuadricCommand::add_to(CLI::App& app) { add_quadric_options(app, options_); }

Result<CommandFiles> QuadricCommand::files() const {
    const FoldersMadeLater later;
    const Result<QuadricCommandOptions> plan = plan_quadric(options_);
    if (!plan) return tl::unexpected(plan.error());
    CommandFiles files;
    files.inputs.push_back(plan->input);
    files.outputs.push_back(plan->output);
    if (!plan->preview.empty()) files.outputs.push_back(plan->preview);
    files.arguments = "quadric\nfit=" + word_of_fit(plan->quadric.fit) + "\nterms=" + std::to_string(plan->quadric.twist) +
                      "\nframe=" + (plan->quadric.frame == FrameKind::automatic ? "auto" : word_of_frame(plan->quadric.frame)) + "\nstore=" + word_of_store(plan->store) + "\n";
    files.max_bytes = plan->read.max_bytes;
    return files;
}

Result<void> QuadricCommand::run() {
    const Result<QuadricCommandOptions> plan = plan_quadric(options_);
    if (!plan) return tl::unexpected(plan.error());
    StageClock clock(!plan->quiet);
    const Result<MeshFile> file = clock.time("read", [&] { return read_mesh(plan->input, plan->read); });
    if (!file) return tl::unexpected(file.error());
    const Result<std::vector<QuadricBake>> bakes = clock.time("bake", [&] { return bake_all(*plan, *file); });
    if (!bakes) return tl::unexpected(bakes.error());
    const Result<void> written = clock.time("write", [&] { return write_all(*plan, *file, *bakes); });
    if (!written) return written;
    clock.stop();

    QuadricRun run{*plan, *file, *bakes, add_up(*bakes), summarise(*bakes), {}};
    run.warnings = quadric_warnings(run);
    for (const std::string& warning : run.warnings) print_warning("quadric", warning);
    if (plan->quiet) return {};
    print_result(plan->json ? quadric_result_text(run, clock.seconds()) : quadric_summary(run, clock.seconds()));
    return {};
}

} // namespace reliefbake

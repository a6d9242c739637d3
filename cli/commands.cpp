#include "cli/command.h"

#include "cli/advise/advise.h"
#include "cli/batch/batch.h"
#include "cli/bench/bench_also.h"
#include "cli/bench/bench_cone.h"
#include "cli/bench/bench_dynamic.h"
#include "cli/bench/bench_peer.h"
#include "cli/bench/bench_quadric.h"
#include "cli/bench/bench_render.h"
#include "cli/bench/bench_scene.h"
#include "cli/bench/bench_shape.h"
#include "cli/bench/bench_surface.h"
#include "cli/bench/bench_terrain.h"
#include "cli/bump/bake_bump.h"
#include "cli/cone/bake_families.h"
#include "cli/explain/explain.h"
#include "cli/merge/merge.h"
#include "cli/plan/plan.h"
#include "cli/quadric/bake_quadric.h"
#include "cli/render/render.h"
#include "cli/render/shader.h"
#include "cli/scene/scene_command.h"
#include "cli/shape/bake_shape.h"
#include "cli/stress/stress.h"
#include "cli/tradeoff/tradeoff.h"
#include "cli/verify/verify.h"

namespace reliefbake {

namespace {

template <class T>
std::unique_ptr<Command> make() {
    return std::make_unique<T>();
}

constexpr CommandEntry all_commands[] = {
    {"cone", "Bake a height map into a cone map (normal, cone, depth)", make<ConeCommand>},
    {"acm", "Bake an anisotropic cone map: one cone per sector of azimuth", make<AcmCommand>},
    {"cone-normal", "Bake a cone normal map: no cap, the code is also a distance", make<ConeNormalCommand>},
    {"cone-stack", "Bake cones stacked above each texel", make<ConeStackCommand>},
    {"shape", "Bake a binary shape into a shape map (gradient, distance, shape)", make<ShapeCommand>},
    {"bump", "Bake a height map into derivatives, normals or horizons, for shading", make<BumpCommand>},
    {"quadric", "Bake a mesh's curvature into its vertices, for curved relief rendering", make<QuadricCommand>},
    {"batch", "Bake folders of files: only what changed, side by side, through any interruption", make<BatchCommand>},
    {"run", "Bake one shard of a batch that several machines share", make<RunCommand>},
    {"plan", "Print a batch as commands, a build.ninja, or a job for Slurm or Kubernetes", make<PlanCommand>},
    {"bench cone", "Time the cone bake, beside the ways others bake", make<BenchConeCommand>},
    {"bench also", "Time several maps of one source, apart and in one run (--also)", make<BenchAlsoCommand>},
    {"bench dynamic", "Bake anisotropic maps of a moving surface, maps a second", make<BenchDynamicCommand>},
    {"bench shape", "Time the distance transform, beside others", make<BenchShapeCommand>},
    {"bench peer", "Write the map that another method bakes, for render and verify", make<BenchPeerCommand>},
    {"bench quadric", "Time the fit of quadrics, and judge it on known surfaces", make<BenchQuadricCommand>},
    {"bench render", "Time the frames of a cone map", make<BenchRenderCommand>},
    {"bench scene", "Time a scene's maps, and those of baking everything", make<BenchSceneCommand>},
    {"bench surface", "Write a mesh of a known surface, for curved relief", make<BenchSurfaceCommand>},
    {"bench terrain", "Write a large height map, to bake", make<BenchTerrainCommand>},
    {"explain", "Print what a baked map means and how to decode it", make<ExplainCommand>},
    {"merge", "Join the bands of a large map (cone --rows), or the shards of a batch (run), that were baked apart", make<MergeCommand>},
    {"render", "Draw a baked map with the reference shaders", make<RenderCommand>},
    {"scene", "Bake exactly the maps that a scene's assets need", make<SceneCommand>},
    {"shader", "Print the shader that decodes and marches a baked map", make<ShaderCommand>},
    {"stress", "Report what each encoding keeps at the numerical extremes", make<StressCommand>},
    {"tradeoff", "Measure what techniques, steps, bits and resolutions cost and bring on a map", make<TradeoffCommand>},
    {"advise", "Choose the cheapest map and technique that meet a budget of error, steps and bytes", make<AdviseCommand>},
    {"verify", "Judge a baked map against an exact oracle", make<VerifyCommand>},
};

} // namespace

std::span<const CommandEntry> commands() { return all_commands; }

} // namespace reliefbake

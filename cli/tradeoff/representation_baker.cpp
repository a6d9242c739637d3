#include "cli/tradeoff/representation_baker.h"

#include "bake/mips.h"
#include "bake/normal_map.h"
#include "cli/cone/assemble_map.h"
#include "cli/cone/bake_planes.h"
#include "cli/cone/cone_info.h"

#include <chrono>

namespace reliefbake {
namespace {

/// Seconds that `work` takes.
template <class Work>
double timed(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

ConePlan plan_of(const Representation& wanted, double depth_scale, int threads) {
    ConePlan plan;
    plan.given.kind = wanted.has_cones() ? wanted.kind : "cone", plan.given.planes = wanted.planes, plan.given.encoding = wanted.encoding;
    plan.given.held.cones = wanted.has_cones();
    plan.bits = wanted.bits;
    plan.depth_scale = depth_scale;
    plan.cone = wanted.cone, plan.cone.threads = threads;
    return plan;
}

/// Whether two representations of one stored depth hold the same cones, in whatever code.
bool same_cones(Representation a, const Representation& b) {
    a.encoding = b.encoding;
    return a == b;
}

} // namespace

Result<void> RepresentationBaker::prepare_surface(const Representation& wanted) {
    if (surface_ && surface_->bits == wanted.bits && surface_->level == wanted.level) return {};
    cones_.reset();
    surface_.reset();
    DepthMap depth = quantise_depth(*source_.field, wanted.bits);
    if (wanted.level > 0) {
        std::vector<DepthMap> chain = bake_depth_mips(depth);
        if (std::size_t(wanted.level) >= chain.size())
            return fail(ErrorCode::usage, "resolution 1/2^" + std::to_string(wanted.level) + ": the map has " + std::to_string(chain.size()) + " mip levels");
        depth = std::move(chain[std::size_t(wanted.level)]);
    }
    surface_.emplace(Surface{wanted.bits, wanted.level, std::move(depth), {}, {}, 0});
    surface_->seconds = timed([&] { surface_->normals = bake_normals(surface_->depth, depth_scale_, threads_); });
    return {};
}

void RepresentationBaker::prepare_cones(const Representation& wanted) {
    if (cones_ && same_cones(cones_->made_of, wanted)) return;
    cones_.emplace(Cones{wanted, {}, 0});
    const ConePlan plan = plan_of(wanted, depth_scale_, threads_);
    cones_->seconds = timed([&] { cones_->planes = bake_planes(plan, surface_->depth, nullptr, &surface_->pyramids); });
}

Result<const BakedRepresentation*> RepresentationBaker::bake(const Representation& wanted) {
    if (baked_ && baked_->made_of == wanted) return &*baked_;
    baked_.reset();
    if (Result<void> ready = prepare_surface(wanted); !ready) return tl::unexpected(ready.error());
    const DepthMap& depth = surface_->depth;
    if (!wanted.has_cones()) {
        const ReliefMapInfo info = describe_cones(plan_of(wanted, depth_scale_, threads_), source_, depth, {}, {});
        baked_.emplace(BakedRepresentation{wanted, assemble_map(info, depth, {}, surface_->normals), surface_->seconds});
        return &*baked_;
    }
    prepare_cones(wanted);
    std::vector<EncodedConeMap> encoded;
    const double seconds = timed([&] {
        for (const ConeMap& map : cones_->planes) encoded.push_back(encode_cones(map, depth, {wanted.encoding, wanted.bits}));
    });
    const ReliefMapInfo info = describe_cones(plan_of(wanted, depth_scale_, threads_), source_, depth, cones_->planes, encoded);
    baked_.emplace(BakedRepresentation{wanted, assemble_map(info, depth, std::move(encoded), surface_->normals), surface_->seconds + cones_->seconds + seconds});
    return &*baked_;
}

} // namespace reliefbake

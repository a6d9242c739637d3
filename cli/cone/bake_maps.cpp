#include "cli/cone/bake_maps.h"

#include "bake/mips.h"
#include "bake/normal_map.h"
#include "bake/shared_pyramids.h"
#include "cli/cone/assemble_map.h"
#include "cli/cone/bake_mips.h"
#include "cli/cone/bake_planes.h"
#include "cli/cone/cone_info.h"
#include "cli/cone/cone_warnings.h"
#include "formats/map_file.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

namespace reliefbake {

namespace {

/// Whether two plans of the same depth of bits search for the same cones.
bool same_cones(const ConePlan& a, const ConePlan& b) {
    return !a.given.mips && !b.given.mips && a.given.kind == b.given.kind && a.given.planes == b.given.planes &&
           a.given.adaptive == b.given.adaptive && a.cone == b.cone && a.given.held.cones && b.given.held.cones;
}

/// One surface as it is stored, and what maps of it have in common.
struct Surface {
    BitDepth bits;
    int level; ///< mip level of the source
    DepthMap depth;
    SharedPyramids pyramids;
    std::optional<NormalMap> normals;
    std::vector<std::pair<const ConePlan*, std::vector<ConeMap>>> cones; ///< those that a later plan wants again
};

/// The maps of one run, one after the other.
class Run {
  public:
    Run(const std::vector<ConePlan>& plans, BakeSource source) : plans_(plans), source_(std::move(source)) {}

    Result<BakedMap> bake(std::size_t index, StageClock& clock, FileBatch& batch) {
        const ConePlan& plan = plans_[index];
        const Result<Surface*> found = surface_of(index, clock);
        if (!found) return tl::unexpected(found.error());
        Surface& surface = **found;
        Result<BakedMap> baked = plan.given.mips ? bake_chain(plan, surface, clock, batch) : bake_one(index, surface, clock, batch);
        if (!is_wanted_later(index)) std::erase_if(surfaces_, [&](const Surface& old) { return of_surface(plan, old.bits, old.level); });
        return baked;
    }

    BakeSource take_source() { return std::move(source_); }

  private:
    static bool of_surface(const ConePlan& plan, BitDepth bits, int level) { return plan.bits == bits && plan.given.level == level; }

    template <class Wants>
    bool any_later(std::size_t index, Wants wants) const {
        return std::any_of(plans_.begin() + std::ptrdiff_t(index) + 1, plans_.end(), wants);
    }
    bool is_wanted_later(std::size_t index) const {
        return any_later(index, [&](const ConePlan& later) { return of_surface(later, plans_[index].bits, plans_[index].given.level); });
    }

    /// Errors (usage): the heights have no such mip level.
    Result<Surface*> surface_of(std::size_t index, StageClock& clock) {
        const auto stored_for = [&](const ConePlan& plan) {
            return std::find_if(surfaces_.begin(), surfaces_.end(), [&](const Surface& known) { return of_surface(plan, known.bits, known.level); });
        };
        const ConePlan& plan = plans_[index];
        if (const auto known = stored_for(plan); known != surfaces_.end()) return &*known;
        DepthMap depth = clock.time("quantise", [&] { return quantise_depth(*source_.field, plan.bits); });
        if (plan.given.level > 0) {
            std::vector<DepthMap> chain = clock.time("mips", [&] { return bake_depth_mips(depth); });
            if (std::size_t(plan.given.level) >= chain.size())
                return fail(ErrorCode::usage, "--level: the heights of " + plan.given.input + " have mip levels 0 to " + std::to_string(chain.size() - 1) + ", not " +
                                                  std::to_string(plan.given.level));
            depth = std::move(chain[std::size_t(plan.given.level)]);
        }
        surfaces_.push_back({plan.bits, plan.given.level, std::move(depth), {}, {}, {}});
        const auto needs_field = [&](const ConePlan& later) { return stored_for(later) == surfaces_.end(); };
        if (!any_later(index, needs_field)) source_.field.reset();
        return &surfaces_.back();
    }

    /// Baked, or those of an earlier plan; kept while a later one wants them.
    std::vector<ConeMap> cones_of(std::size_t index, Surface& surface, StageClock& clock) {
        const ConePlan& plan = plans_[index];
        if (!plan.given.held.cones) return {};
        const bool again = any_later(index, [&](const ConePlan& later) { return of_surface(later, plan.bits, plan.given.level) && same_cones(later, plan); });
        const auto known = std::find_if(surface.cones.begin(), surface.cones.end(),
                                        [&](const auto& kept) { return same_cones(*kept.first, plan); });
        if (known != surface.cones.end()) {
            if (again) return known->second;
            std::vector<ConeMap> last = std::move(known->second);
            surface.cones.erase(known);
            return last;
        }
        ConeStatistics statistics;
        std::vector<ConeMap> cones = clock.time("cone", [&] { return bake_planes(plan, surface.depth, &statistics, &surface.pyramids); });
        clock.add("cone_near", statistics.seconds_near);
        clock.add("cone_pyramid", statistics.seconds_pyramid);
        clock.add("cone_search", statistics.seconds_search);
        if (again) surface.cones.emplace_back(&plan, cones);
        return cones;
    }

    NormalMap normals_of(std::size_t index, Surface& surface, StageClock& clock) {
        const ConePlan& plan = plans_[index];
        if (!plan.given.held.normals) return {};
        if (!surface.normals)
            surface.normals = clock.time("normals", [&] { return bake_normals(surface.depth, plan.depth_scale, plan.cone.threads); });
        return is_wanted_later(index) ? *surface.normals : std::move(*surface.normals);
    }

    Result<BakedMap> bake_one(std::size_t index, Surface& surface, StageClock& clock, FileBatch& batch) {
        const ConePlan& plan = plans_[index];
        const ConeCommandOptions& given = plan.given;
        std::vector<ConeMap> cones = cones_of(index, surface, clock);
        std::vector<EncodedConeMap> encoded = clock.time("encode", [&] {
            std::vector<EncodedConeMap> maps;
            for (const ConeMap& map : cones) maps.push_back(encode_cones(map, surface.depth, {given.encoding, plan.bits}));
            return maps;
        });
        NormalMap normals = normals_of(index, surface, clock);

        BakedMap baked{plan, describe_cones(plan, source_, surface.depth, cones, encoded), surface.depth.grid,
                       cone_warnings(given, source_.image, surface.depth, cones, encoded), {}, {}};
        cones = {};

        DepthMap depth = is_wanted_later(index) ? surface.depth : std::move(surface.depth);
        const ReliefMap map = assemble_map(baked.info, std::move(depth), std::move(encoded), std::move(normals));
        const Result<void> written = clock.time("write", [&] { return write_map(given.output, map, batch, plan.cone.threads); });
        if (!written) return tl::unexpected(written.error());
        if (given.relief_output.empty()) return baked;
        const Result<void> beside = clock.time("write_relief", [&] {
            return write_map(given.relief_output, relief_map_for(map), batch, plan.cone.threads);
        });
        if (!beside) return tl::unexpected(beside.error());
        return baked;
    }

    Result<BakedMap> bake_chain(const ConePlan& plan, Surface& surface, StageClock& clock, FileBatch& batch) {
        const Result<MipRun> mips = bake_mips(plan, source_, {surface.depth, &surface.pyramids}, batch, clock);
        if (!mips) return tl::unexpected(mips.error());
        return BakedMap{plan, mips->info, mips->levels[0].grid, mips->warnings, {}, mips->levels};
    }

    const std::vector<ConePlan>& plans_;
    BakeSource source_;
    std::deque<Surface> surfaces_; ///< those that a later plan wants, too
};

} // namespace

Result<BakedMaps> bake_maps(const std::vector<ConePlan>& plans) {
    const ConeCommandOptions& shared = plans.front().given;
    std::optional<StageClock> clock(std::in_place, !shared.quiet);
    Result<BakeSource> source = read_source(shared, *clock);
    if (!source) return tl::unexpected(source.error());
    Run run(plans, std::move(*source));
    FileBatch batch;
    BakedMaps all;
    for (std::size_t index = 0; index < plans.size(); ++index) {
        if (index > 0) clock.emplace(!shared.quiet);
        Result<BakedMap> baked = run.bake(index, *clock, batch);
        if (!baked) return tl::unexpected(baked.error());
        clock->stop();
        baked->seconds = clock->seconds();
        all.maps.push_back(std::move(*baked));
    }
    if (Result<void> published = batch.publish(); !published) return tl::unexpected(published.error());
    all.source = run.take_source();
    return all;
}

} // namespace reliefbake

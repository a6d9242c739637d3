#include "cli/tradeoff/sweep_plan.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace reliefbake {
namespace {

/// Indices into the axes.
struct Place {
    std::size_t refinement = 0, encoding = 0, bits = 0, level = 0, tolerance = 0;
    bool is_base() const { return refinement + encoding + bits + level + tolerance == 0; }
};

std::vector<Place> all_places(const SweepAxes& axes) {
    std::vector<Place> places;
    for (Place p; p.bits < axes.bits.size(); ++p.bits)
        for (p.level = 0; p.level < axes.levels.size(); ++p.level)
            for (p.tolerance = 0; p.tolerance < axes.tolerances.size(); ++p.tolerance)
                for (p.encoding = 0; p.encoding < axes.encodings.size(); ++p.encoding)
                    for (p.refinement = 0; p.refinement < axes.refinements.size(); ++p.refinement) {
                        const int moved = (p.bits > 0) + (p.level > 0) + (p.tolerance > 0) + (p.encoding > 0) + (p.refinement > 0);
                        if (axes.full || moved <= 1) places.push_back(p);
                    }
    return places;
}

/// The method's candidate at a place; axes that mean nothing to it stay as they are.
Candidate candidate_at(const Method& method, const SweepAxes& axes, const Place& place) {
    Candidate candidate = method.base;
    Representation& map = candidate.map;
    map.bits = axes.bits[place.bits], map.level = axes.levels[place.level];
    if (map.has_cones()) {
        map.cone.tolerance = axes.tolerances[place.tolerance];
        if (map.encoding != ConeEncoding::normal) map.encoding = axes.encodings[place.encoding]; // a cone normal is one
    }
    if (technique_info(candidate.march.technique).refines) candidate.march.refinements = axes.refinements[place.refinement];
    return candidate;
}

class Plan {
  public:
    void add(const Method& method, Candidate candidate, const std::vector<int>& steps, bool base) {
        for (const int count : steps) {
            candidate.march.steps = count;
            if (check_candidate(candidate) && seen_.insert(id_of(candidate)).second) planned_.push_back({&method, candidate, base});
        }
    }

    /// Equal stored depths together, then equal cones, then equal codes.
    std::vector<PlannedCandidate> in_order() {
        const auto key = [](const PlannedCandidate& planned) {
            Representation cones = planned.candidate.map;
            cones.encoding = ConeEncoding::ratio;
            return std::tuple(int(cones.bits), cones.level, id_of(cones), id_of(planned.candidate.map));
        };
        std::stable_sort(planned_.begin(), planned_.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
        return std::move(planned_);
    }

  private:
    std::vector<PlannedCandidate> planned_;
    std::set<std::string> seen_;
};

} // namespace

std::vector<PlannedCandidate> plan_sweep(const SweepAxes& axes) {
    Plan plan;
    const std::vector<Place> places = all_places(axes);
    for (const Method& method : all_methods()) {
        const bool named = std::find(axes.methods.begin(), axes.methods.end(), method.word) != axes.methods.end();
        if (!named && !(axes.methods.empty() && method.by_default)) continue;
        for (const bool base : {true, false}) // a candidate that several places yield is the base's
            for (const Place& place : places)
                if (place.is_base() == base) plan.add(method, candidate_at(method, axes, place), axes.steps, base);
    }
    return plan.in_order();
}

std::vector<PlannedCandidate> plan_marches(const Representation& stored, const SweepAxes& axes) {
    Plan plan;
    for (const Method& method : all_methods()) {
        const bool named = std::find(axes.methods.begin(), axes.methods.end(), method.word) != axes.methods.end();
        if (!named && !axes.methods.empty()) continue;
        const Representation& wants = method.base.map;
        const bool height = !wants.has_cones();
        const bool same = wants.kind == stored.kind && wants.cone.family == stored.cone.family && (wants.encoding == ConeEncoding::normal) == (stored.encoding == ConeEncoding::normal);
        if (!height && !(stored.has_cones() && same && wants.cone.lookup == stored.cone.lookup && wants.cone.rays == stored.cone.rays)) continue;
        for (const int refinements : axes.refinements) {
            Candidate candidate{stored, method.base.march};
            if (height) candidate.map.kind = "height", candidate.map.planes = 1;
            candidate.march.refinements = technique_info(candidate.march.technique).refines ? refinements : 0;
            plan.add(method, candidate, axes.steps, refinements == axes.refinements.front());
        }
    }
    return plan.in_order();
}

} // namespace reliefbake

#include "cli/advise/advice_search.h"

#include <algorithm>

namespace reliefbake {
namespace {

constexpr std::size_t ways_wanted = 2;       ///< the answer and the runner-up
constexpr std::size_t last_chances = 3;

class Search {
  public:
    Search(std::span<const Way> ways, const Budget& budget, const Measurers& measurers) : budget_(budget), measurers_(measurers) {
        const auto finer = [](const Way& a, const Way& b) {
            const Representation &x = a.marches.front().map, &y = b.marches.front().map;
            return x.level != y.level ? x.level > y.level : x.bits < y.bits;
        };
        if (!ways.empty()) finest_ = surface_of(std::max_element(ways.begin(), ways.end(), finer)->marches.front());
    }

    bool is_done() const { return answers_.size() >= ways_wanted; }

    /// The ways from `begin` on that cost equal bytes.
    Result<void> try_tier(std::span<const Way> tier) {
        std::vector<std::size_t> near;
        for (const Way& way : tier) {
            const Result<bool> fits = surface_fits(surface_of(way.marches.front()), false);
            if (!fits) return tl::unexpected(fits.error());
            if (!*fits) {
                advice_.given_up.push_back(&way);
                continue;
            }
            if (Result<void> screened = screen(way, near); !screened) return screened;
        }
        std::sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) { return is_cheaper(advice_.trials[a], advice_.trials[b]); });
        for (const std::size_t k : near) {
            if (is_done()) return {};
            const Result<bool> fits = surface_fits(surface_of(advice_.trials[k].candidate), true);
            if (!fits) return tl::unexpected(fits.error());
            if (!*fits) continue;
            if (Result<void> tried = prove(k); !tried) return tried;
        }
        return {};
    }

    /// Of what was screened alone, the nearest.
    Result<void> try_nearest() {
        std::vector<std::size_t> rest;
        for (std::size_t k = 0; k < advice_.trials.size(); ++k)
            if (!advice_.measured[k].proven && !was_proven(advice_.trials[k].candidate)) rest.push_back(k);
        std::stable_sort(rest.begin(), rest.end(), [&](std::size_t a, std::size_t b) {
            return excess_of(advice_.trials[a].figures, budget_, Margin::none) < excess_of(advice_.trials[b].figures, budget_, Margin::none);
        });
        for (std::size_t k = 0; k < std::min(rest.size(), last_chances); ++k)
            if (Result<void> tried = prove(rest[k]); !tried) return tried;
        return {};
    }

    bool found_none() const { return answers_.empty(); }

    /// The choice among what was proven.
    Advice finish() {
        std::vector<Trial> proven;
        std::vector<std::size_t> places;
        for (std::size_t k = 0; k < advice_.trials.size(); ++k)
            if (advice_.measured[k].proven) proven.push_back(advice_.trials[k]), places.push_back(k);
        advice_.choice = choose(proven, budget_);
        for (std::optional<std::size_t>* index : {&advice_.choice.answer, &advice_.choice.runner_up, &advice_.choice.nearest})
            if (*index) *index = places[**index];
        return std::move(advice_);
    }

    void leave(const Way& way) { advice_.untried.push_back(&way); }

  private:
    Result<bool> surface_fits(const StoredSurface& surface, bool proven) {
        if (surface == finest_) return true;
        for (const Advice::Probed& known : advice_.surfaces)
            if (known.surface == surface && known.proven == proven) return !known.given_up;
        const Result<Measurement> figures = (proven ? measurers_.prove : measurers_.screen)(probe_of(surface));
        if (!figures) return tl::unexpected(figures.error());
        Measurement lost = *figures; // neither its bytes nor its steps are those of the ways
        lost.bytes_per_texel = lost.steps_max = 0;
        const bool given_up = excess_of(lost, budget_, Margin::none) > surface_slack;
        advice_.surfaces.push_back({surface, proven, *figures, given_up});
        return !given_up;
    }

    /// Adds the indices of those near the budget.
    Result<void> screen(const Way& way, std::vector<std::size_t>& near) {
        for (const Candidate& candidate : way.marches) {
            const Result<std::size_t> measured = measure(candidate, way.method, false);
            if (!measured) return tl::unexpected(measured.error());
            if (excess_of(advice_.trials[*measured].figures, budget_, Margin::none) > screen_slack) break;
            near.push_back(*measured);
        }
        return {};
    }

    /// Proves trial k, unless the same map and technique meets the budget already with a cheaper march.
    Result<void> prove(std::size_t k) {
        const Candidate candidate = advice_.trials[k].candidate;
        const auto same_way = [&](const Candidate& other) { return is_same_way(candidate, other); };
        if (std::any_of(answers_.begin(), answers_.end(), same_way)) return {};
        const Result<std::size_t> measured = measure(candidate, advice_.measured[k].method, true);
        if (!measured) return tl::unexpected(measured.error());
        if (meets(advice_.trials[*measured].figures, budget_)) answers_.push_back(candidate);
        return {};
    }

    Result<std::size_t> measure(const Candidate& candidate, const Method* method, bool proven) {
        Result<Measurement> figures = (proven ? measurers_.prove : measurers_.screen)(candidate);
        if (!figures) return tl::unexpected(figures.error());
        advice_.trials.push_back({candidate, *figures});
        advice_.measured.push_back({method, proven});
        return advice_.trials.size() - 1;
    }

    bool was_proven(const Candidate& candidate) const {
        for (std::size_t k = 0; k < advice_.trials.size(); ++k)
            if (advice_.measured[k].proven && advice_.trials[k].candidate == candidate) return true;
        return false;
    }

    const Budget& budget_;
    const Measurers& measurers_;
    Advice advice_;
    std::vector<Candidate> answers_; ///< proven to meet the budget
    std::optional<StoredSurface> finest_;
};

} // namespace

std::size_t Advice::count(bool proven) const {
    return std::size_t(std::count_if(measured.begin(), measured.end(), [&](const Measured& one) { return one.proven == proven; }));
}

Result<Advice> search_advice(const std::vector<Way>& ways, const Budget& budget, const Measurers& measurers) {
    Search search(ways, budget, measurers);
    for (std::size_t begin = 0, end; begin < ways.size(); begin = end) {
        for (end = begin + 1; end < ways.size() && ways[end].bytes_per_texel == ways[begin].bytes_per_texel;) ++end;
        const std::span<const Way> tier(ways.data() + begin, end - begin);
        if (search.is_done()) {
            for (const Way& way : tier) search.leave(way);
            continue;
        }
        if (Result<void> tried = search.try_tier(tier); !tried) return tl::unexpected(tried.error());
    }
    if (search.found_none())
        if (Result<void> tried = search.try_nearest(); !tried) return tl::unexpected(tried.error());
    return search.finish();
}

} // namespace reliefbake

#pragma once
// Pyramids that several bakes of one surface can share.

#include "bake/cone.h"
#include "bake/flip.h"
#include "bake/max_pyramid.h"
#include "bake/search_surface.h"

#include <deque>
#include <optional>

namespace reliefbake {

/// The pyramids of one stored depth map, each built when a bake first asks for it. Cost: about 1.4 bytes a texel each, of which
/// a surface has one, and four for sectors and relaxed cones each. For one bake at a time.
class SharedPyramids {
  public:
    /// What a pyramid is of: the surface flipped; or of its exits alone (whose distances the metric counts).
    struct Subject {
        Flip flip;
        std::optional<ExitRule> exits;
        Metric metric = Metric::l2;
        friend bool operator==(const Subject&, const Subject&) = default;
    };

    /// `heights` are those of the subject, the same for the same subject.
    const MaxPyramid& of(const Subject& subject, const Image<float>& heights, int threads) {
        for (const auto& [known, pyramid] : pyramids_)
            if (known == subject) return pyramid;
        return pyramids_.emplace_back(subject, build_max_pyramid(heights, threads)).second;
    }

  private:
    std::deque<std::pair<Subject, MaxPyramid>> pyramids_; ///< a deque: references stay
};

} // namespace reliefbake

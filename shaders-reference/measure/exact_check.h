#pragma once
// Guarantee C of one baked map in rational numbers, beside what doubles say of the same points.

#include "bake/relief_map.h"
#include "shaders-reference/oracle/exact_cone.h"

namespace reliefbake {

/// The widest cone that a bilinear or nearest fetch gives at a point of the half-texel lattice (`radius`: bilinear alone), decoded
/// without rounding, squared; nullopt: without bound.
/// A unorm code k of n counts as k / n; `radius` at depth 0 stands for cone_max.
std::optional<Rational> exact_ratio_squared(const ReliefMap& map, HalfTexel point);

struct ExactCheck {
    std::uint64_t points = 0;
    std::uint64_t violated = 0;  ///< proved to hold a point of the surface
    std::uint64_t undecided = 0; ///< neither proved
    std::uint64_t doubles_wrong = 0; ///< points where the oracle in doubles (ratio * constraint > 1 + 1e-6) says otherwise than the proof
    std::uint64_t doubles_above = 0; ///< proved to hold, and the oracle in doubles sees ratio * constraint > 1, within its rounding
    HalfTexel worst{0, 0};       ///< the first point that does not hold
};

/// Maps of kind "cone", conservative, filtered, surface bilinear, without holes: `points` points of the half-texel lattice (all of
/// them if there are not more), in even strides. `threads`: 0: all; the result does not depend on it.
ExactCheck check_exactly(const ReliefMap& map, int points, int threads = 0);

} // namespace reliefbake

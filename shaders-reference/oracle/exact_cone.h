#pragma once
// Guarantee C decided in rational numbers, where doubles can only say "within rounding".

#include "bake/cone.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace reliefbake {

using Rational = boost::multiprecision::cpp_rational;

/// The double itself: every finite double is a rational number.
Rational exactly(double value);

/// The stored bilinear surface without rounding: levels, in which it goes up, and positions in texels.
class ExactSurface {
  public:
    explicit ExactSurface(const DepthMap& depth);

    const TexelGrid& grid() const { return grid_; }
    double highest() const { return highest_; } ///< -level, exact
    /// -level of a texel, addressed as the grid says; max_code of them are one unit of height.
    double rise(int i, int j) const { return rises_(grid_.address_x(i), grid_.address_y(j)); }
    int levels() const { return levels_; }

  private:
    TexelGrid grid_;
    Image<float> rises_;
    double highest_;
    int levels_;
};

/// A point of the half-texel lattice: texel centre (i, j) is (2 i, 2 j); on a clamped axis between the border's centres.
struct HalfTexel {
    int x, y;
};

enum class ExactVerdict {
    holds,     ///< proved: no point of the surface lies inside the cone
    violated,  ///< proved: one does
    undecided, ///< the budget of boxes was spent first (the surface touches the cone, or nearly)
};

struct ExactJudgement {
    ExactVerdict verdict = ExactVerdict::holds;
    std::uint64_t boxes = 0; ///< looked at in rational numbers
};

/// Whether some point q of the surface has  H(q) > H(p)  and  r (H(q) - H(p)) > |q - p|,  p the apex on the surface.
/// `ratio_squared`: r^2 in texture widths per unit of height; nullopt: a cone without bound. Touching is allowed.
///
/// Branch and bound over boxes of cells. With u any vector of length at most 1 (in l1: each component at most 1),
/// |q - p| >= u.(q - p), and  r (H(q) - H(p)) - u.(q - p)  is bilinear over a box, so
///
///     r (H - H(p)) <= u.(q - p) at the four corners  clears the box;  a corner inside the cone convicts it.
///
/// In the apex' own cells the rise of a chord is the gradient at its middle times its length, and the gradient's length is convex:
/// r |grad| <= 1 at the corners of the box of middles clears the box.
/// r is replaced by a rational number above it, by less than 2^-60 of it; all else is exact. No holes.
ExactJudgement judge_exactly(const ExactSurface& surface, HalfTexel apex, const std::optional<Rational>& ratio_squared, Metric metric,
                             std::uint64_t most_boxes = 4000);

} // namespace reliefbake

#pragma once
// Horizons of a curve seen from points on it: a sweep with a convex hull (Timonen and Westerholm 2010, "Scalable height
// field self-shadowing"), here exact for the parabolas that a bilinear surface has along a diagonal.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace reliefbake {

/// The curve over one step of a walk: h + b t + c t^2, t in [0, 1].
struct CurveStep {
    double h = 0, b = 0, c = 0;
};

/// The upper convex hull of a curve right of where the sweep stands: points, and arcs that bulge above their chords.
///
/// Every piece knows its `bridge`, the slope of the line that lies on it and on the piece behind it. Bridges fall from the
/// front to the back, so that the slope from a point further left rises from piece to piece up to the one it touches.
class HorizonHull {
  public:
    /// sup of (y - h) / (x' - x) over all (x', y) of the curve in the hull; -inf where there is none. Pieces that (x, h)
    /// hides, hidden from all points further left too, are dropped: (x, h) must lie on the curve.
    double slope_from(double x, double h) {
        double slope = none;
        while (!pieces_.empty()) {
            slope = tangent(x, h, pieces_.back());
            if (slope > pieces_.back().bridge) break;
            pieces_.pop_back();
        }
        return slope;
    }

    /// Adds the curve over [x, x + 1], left of all there is; the hull then holds everything from x on.
    void push(double x, const CurveStep& step) {
        const bool arc = step.c < 0;
        Piece piece{x, step.h, arc ? step.b : 0, arc ? step.c : 0, none};
        while (!pieces_.empty()) {
            piece.bridge = bridge(piece, pieces_.back());
            if (piece.bridge > pieces_.back().bridge) break;
            pieces_.pop_back();
        }
        if (pieces_.empty()) piece.bridge = none;
        pieces_.push_back(piece);
    }

  private:
    static constexpr double none = -std::numeric_limits<double>::infinity();

    /// A point (b = c = 0), or an arc over [x, x + 1] with c < 0.
    struct Piece {
        double x, h, b, c;
        double bridge;

        bool is_arc() const { return c < 0; }
        double height(double t) const { return h + (b + c * t) * t; }
        /// Where a line of slope m lies on it.
        double contact(double m) const { return is_arc() ? std::clamp((m - b) / (2 * c), 0.0, 1.0) : 0.0; }
    };

    /// On an arc (y - h) / s = a / s + b' + c s, greatest at s = sqrt(a / c) when a < 0, else where the arc begins.
    static double tangent(double x, double h, const Piece& piece) {
        const double begin = piece.x - x, rise = piece.h - h;
        if (!piece.is_arc()) return rise / begin;
        const double a = rise - piece.b * begin + piece.c * begin * begin;
        const double s = a < 0 ? std::clamp(std::sqrt(a / piece.c), begin, begin + 1) : begin;
        const double t = s - begin;
        return (rise + (piece.b + piece.c * t) * t) / s;
    }

    /// Slope of the line that lies on both, `left` before `right`. Newton's method on the difference of the two supports:
    /// its step is the slope between the two contacts; where a step leaves what is known to hold the root, halve.
    static double bridge(const Piece& left, const Piece& right) {
        if (left.is_arc() && right.x == left.x + 1) {
            // They share a point. A kink that bulges is on the hull itself; a line of either side's slope lies on it.
            if (!right.is_arc()) return none;
            if (left.b + 2 * left.c >= right.b) return right.b;
        }
        double low = none, high = -none, m = (right.h - left.h) / (right.x - left.x);
        for (int round = 0; round < 50; ++round) {
            const double l = left.contact(m), r = right.contact(m);
            const double next = (right.height(r) - left.height(l)) / ((right.x - left.x) + (r - l));
            if (next == m) break;
            (next < m ? high : low) = m;
            const bool inside = next > low && next < high;
            const double step = inside ? next : 0.5 * (low + high);
            if (step == m || !std::isfinite(step)) break;
            m = step;
        }
        return m;
    }

    std::vector<Piece> pieces_;
};

/// Sweeps a curve of `total` steps from its far end and tells, for each k < `seen` of its first points, the horizon's slope:
/// sup over s > 0 of (y(k + s) - y(k)) / s within the curve, height per step, or 0 where nothing rises.
/// curve(k): the CurveStep from k on, asked once each, for k = total - 1 down to 0. take(k, slope): the result.
/// Exact up to a few roundings of double; time and memory are linear in `total` for any curve.
template <class Curve, class Take>
void line_horizons(std::int64_t seen, std::int64_t total, Curve&& curve, Take&& take) {
    HorizonHull hull;
    for (std::int64_t k = total - 1; k >= 0; --k) {
        const CurveStep step = curve(k);
        // Within its own step the slope b + c t is greatest at one end; at t = 0 it is the limit towards the point.
        const double own = std::max(step.b, step.b + step.c);
        const double beyond = hull.slope_from(double(k), step.h);
        if (k < seen) take(k, std::max({0.0, own, beyond}));
        hull.push(double(k), step);
    }
}

} // namespace reliefbake

#include "mesh/tangent_space.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <numeric>
#include <tuple>

namespace reliefbake {

namespace {

using Imath::V2f;
using Imath::V3f;

constexpr std::uint32_t none = 0xffffffff;

bool not_zero(float x) { return std::fabs(x) > FLT_MIN; }
bool not_zero(const V3f& v) { return not_zero(v.x) || not_zero(v.y) || not_zero(v.z); }

V3f normalised(const V3f& v) { return not_zero(v) ? v * (1 / std::sqrt(v.dot(v))) : v; }
V3f across(const V3f& v, const V3f& normal) { return normalised(v - normal * normal.dot(v)); }

/// Directions in which a triangle's u and v grow, and how fast.
struct Gradients {
    V3f u{0}, v{0}; ///< unit length, turned so that u and v grow along them
    bool preserves_orientation = false;
    bool any_orientation = true; ///< no area in the texture: it takes what its neighbours have
    bool usable = false;         ///< has area in space: belongs to the mesh at all
};

/// Numbers for distinct (position, normal, uv), by sorting.
std::vector<std::uint32_t> weld_values(const Mesh& mesh, const Weld& weld) {
    const auto key = [&](std::uint32_t v) {
        const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); };
        const V3f& n = mesh.normals[v];
        const V2f& t = mesh.uvs[v];
        return std::tuple(weld.position_of[v], bits(n.x), bits(n.y), bits(n.z), bits(t.x), bits(t.y));
    };
    std::vector<std::uint32_t> order(mesh.positions.size()), number(order.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return std::tuple(key(a), a) < std::tuple(key(b), b); });
    for (std::size_t k = 0; k < order.size(); ++k)
        number[order[k]] = k > 0 && key(order[k - 1]) == key(order[k]) ? number[order[k - 1]] : order[k];
    return number;
}

/// A corner's gradients in the plane across its vertex's normal.
struct Projected {
    V3f u, v, weighted_u;
    bool any_orientation;
};

class Builder {
  public:
    Builder(const Mesh& mesh, const Weld& weld) : mesh_(mesh), number_(weld_values(mesh, weld)) {
        measure_triangles(weld);
        join_neighbours();
        result_.assign(3 * mesh.triangles.size(), Imath::V4f(0));
        group_.assign(result_.size(), none);
    }

    std::vector<Imath::V4f> build() {
        std::uint32_t groups = 0;
        for (std::uint32_t corner = 0; corner < group_.size(); ++corner) {
            const Gradients& g = gradients_[corner / 3];
            if (!g.usable || g.any_orientation || group_[corner] != none) continue;
            collect_group(corner, groups++);
            project_members();
            write_members(g.preserves_orientation);
        }
        borrow_for_degenerate();
        return std::move(result_);
    }

  private:
    std::uint32_t vertex(std::uint32_t corner) const { return mesh_.triangles[corner / 3][corner % 3]; }
    std::uint32_t number(std::uint32_t corner) const { return number_[vertex(corner)]; }
    V3f position(std::uint32_t corner) const { return V3f(mesh_.positions[vertex(corner)]); }
    static std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
    static std::uint32_t previous(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

    void measure_triangles(const Weld& weld);
    void join_neighbours();
    void collect_group(std::uint32_t corner, std::uint32_t group);
    void project_members();
    static bool excludes(const Projected& a, const Projected& b);
    void write_members(bool preserves_orientation);
    void borrow_for_degenerate();

    const Mesh& mesh_;
    std::vector<std::uint32_t> number_;
    std::vector<Gradients> gradients_;
    std::vector<std::uint32_t> neighbour_; ///< triangle across the edge from each corner to the next
    std::vector<std::uint32_t> group_;     ///< of each corner
    std::vector<std::uint32_t> members_;   ///< corners of the group at hand, all at one vertex
    std::vector<Projected> projected_;
    std::vector<Imath::V4f> result_;
};

void Builder::measure_triangles(const Weld& weld) {
    gradients_.resize(mesh_.triangles.size());
    for (std::size_t t = 0; t < gradients_.size(); ++t) {
        Gradients& g = gradients_[t];
        const Triangle& v = mesh_.triangles[t];
        const V3f p[] = {V3f(mesh_.positions[v[0]]), V3f(mesh_.positions[v[1]]), V3f(mesh_.positions[v[2]])};
        const bool finite = std::none_of(v.begin(), v.end(), [&](std::uint32_t k) { return weld.position_of[k] == no_position; });
        g.usable = finite && p[0] != p[1] && p[1] != p[2] && p[2] != p[0];
        if (!g.usable) continue;
        const V2f t21 = mesh_.uvs[v[1]] - mesh_.uvs[v[0]], t31 = mesh_.uvs[v[2]] - mesh_.uvs[v[0]];
        const V3f d1 = p[1] - p[0], d2 = p[2] - p[0];
        const float area = t21.x * t31.y - t21.y * t31.x; // twice, signed
        g.preserves_orientation = area > 0;
        if (!not_zero(area)) continue;
        const float turn = g.preserves_orientation ? 1.0f : -1.0f;
        const V3f u = d1 * t31.y - d2 * t21.y, w = d2 * t21.x - d1 * t31.x;
        const float u_length = u.length(), w_length = w.length();
        if (not_zero(u_length)) g.u = u * (turn / u_length);
        if (not_zero(w_length)) g.v = w * (turn / w_length);
        if (not_zero(u_length / std::fabs(area)) && not_zero(w_length / std::fabs(area))) g.any_orientation = false;
    }
}

/// Two triangles are neighbours where they run along one edge in opposite directions, each at most once an edge.
void Builder::join_neighbours() {
    struct Edge {
        std::uint32_t low, high, corner;
        auto operator<=>(const Edge&) const = default;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * gradients_.size());
    for (std::uint32_t corner = 0; corner < 3 * gradients_.size(); ++corner)
        if (gradients_[corner / 3].usable) {
            const auto [low, high] = std::minmax({number(corner), number(next(corner))});
            edges.push_back({low, high, corner});
        }
    std::sort(edges.begin(), edges.end());
    neighbour_.assign(3 * gradients_.size(), none);
    // Along one edge, each corner takes the first later one that runs the other way and is free.
    for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
        for (end = begin; end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high;) ++end;
        std::size_t free[2] = {begin, begin}; // no one before it is free and runs that way
        for (std::size_t k = begin; k < end; ++k) {
            const std::uint32_t a = edges[k].corner;
            if (neighbour_[a] != none) continue;
            const bool way = number(a) == edges[k].low;
            std::size_t& m = free[!way];
            m = std::max(m, k + 1);
            while (m < end && (neighbour_[edges[m].corner] != none || (number(edges[m].corner) == edges[m].low) == way)) ++m;
            if (m == end) continue;
            neighbour_[a] = edges[m].corner / 3;
            neighbour_[edges[m].corner] = a / 3;
        }
    }
}

/// All corners at one vertex that are reached across edges without a change of orientation.
void Builder::collect_group(std::uint32_t first, std::uint32_t group) {
    const std::uint32_t at = number(first);
    const bool orientation = gradients_[first / 3].preserves_orientation;
    members_.clear();
    std::vector<std::uint32_t> ahead{first / 3};
    while (!ahead.empty()) {
        const std::uint32_t triangle = ahead.back();
        ahead.pop_back();
        std::uint32_t corner = 3 * triangle;
        while (corner < 3 * triangle + 3 && number(corner) != at) ++corner;
        if (corner == 3 * triangle + 3 || group_[corner] != none) continue;
        Gradients& g = gradients_[triangle];
        if (g.any_orientation && group_[3 * triangle] == none && group_[3 * triangle + 1] == none && group_[3 * triangle + 2] == none)
            g.preserves_orientation = orientation; // the first group that reaches it decides
        if (g.preserves_orientation != orientation) continue;
        group_[corner] = group;
        members_.push_back(corner);
        for (const std::uint32_t edge : {previous(corner), corner})
            if (neighbour_[edge] != none) ahead.push_back(neighbour_[edge]);
    }
    std::sort(members_.begin(), members_.end());
}

/// What each member adds to a sum: its directions in the plane across the normal, u weighted by the angle at the vertex.
void Builder::project_members() {
    projected_.clear();
    for (const std::uint32_t corner : members_) {
        const Gradients& g = gradients_[corner / 3];
        const V3f n = mesh_.normals[vertex(corner)], p = position(corner);
        const V3f a = across(position(previous(corner)) - p, n), b = across(position(next(corner)) - p, n);
        const float angle = std::acos(std::clamp(a.dot(b), -1.0f, 1.0f)); // acosf: the same bits on every processor
        const V3f u = across(g.u, n);
        projected_.push_back({u, across(g.v, n), g.any_orientation ? V3f(0) : u * angle, g.any_orientation});
    }
}

/// The standard's angle limit is 180 degrees: only exactly opposite directions are kept apart.
bool Builder::excludes(const Projected& a, const Projected& b) {
    return !a.any_orientation && !b.any_orientation && !(a.u.dot(b.u) > -1 && a.v.dot(b.v) > -1);
}

void Builder::write_members(bool preserves_orientation) {
    const float sign = preserves_orientation != mesh_.v_down ? 1.0f : -1.0f;
    // A fan of a million triangles must not cost their square: a large group has one sum for all.
    constexpr std::size_t most_compared = 256;
    const bool compare = members_.size() <= most_compared;
    V3f tangent(0);
    for (std::size_t k = 0; k < members_.size(); ++k) {
        if (k == 0 || compare) {
            tangent = V3f(0);
            for (std::size_t m = 0; m < members_.size(); ++m)
                if (!compare || m == k || !excludes(projected_[k], projected_[m])) tangent += projected_[m].weighted_u;
            tangent = normalised(tangent);
        }
        if (not_zero(tangent)) result_[members_[k]] = {tangent.x, tangent.y, tangent.z, sign};
    }
}

/// Triangles without area in space take what some other corner with their vertex's values has.
void Builder::borrow_for_degenerate() {
    std::vector<std::uint32_t> lender(number_.size(), none);
    for (std::uint32_t corner = 0; corner < result_.size(); ++corner)
        if (gradients_[corner / 3].usable && lender[number(corner)] == none) lender[number(corner)] = corner;
    for (std::uint32_t corner = 0; corner < result_.size(); ++corner)
        if (!gradients_[corner / 3].usable && lender[number(corner)] != none) result_[corner] = result_[lender[number(corner)]];
}

} // namespace

std::vector<Imath::V4f> tangent_space(const Mesh& mesh, const Weld& weld) { return Builder(mesh, weld).build(); }

} // namespace reliefbake

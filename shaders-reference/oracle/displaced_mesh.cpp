#include "shaders-reference/oracle/displaced_mesh.h"

#include "mesh/weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace reliefbake {

namespace {

using Imath::V2d;
using Imath::V3d;

/// A point of the mesh; all of it is linear along an edge.
struct Corner {
    V3d position, normal;
    V2d place; ///< texels: x = u width - 0.5
};

Corner middle(const Corner& a, const Corner& b) { return {(a.position + b.position) / 2.0, (a.normal + b.normal) / 2.0, (a.place + b.place) / 2.0}; }

/// How often an edge is halved until its parts are no longer than `longest`.
int halvings(const V2d& edge, double longest) { return std::max(0, int(std::ceil(std::log2(edge.length() / longest)))); }

/// Rates of change over one base triangle, per texel; zero where its texture has no area.
struct Rates {
    V3d position_x{0}, position_y{0}, normal_x{0}, normal_y{0};
};

Rates rates_of(const Corner& a, const Corner& b, const Corner& c) {
    const V2d p = b.place - a.place, q = c.place - a.place;
    const double area = p.x * q.y - p.y * q.x;
    if (area == 0) return {};
    const auto along_x = [&](const V3d& s, const V3d& t) { return (s * q.y - t * p.y) / area; };
    const auto along_y = [&](const V3d& s, const V3d& t) { return (t * p.x - s * q.x) / area; };
    const V3d sp = b.position - a.position, tp = c.position - a.position, sn = b.normal - a.normal, tn = c.normal - a.normal;
    return {along_x(sp, tp), along_y(sp, tp), along_x(sn, tn), along_y(sn, tn)};
}

class Displacer {
  public:
    Displacer(const BilinearSurface& relief, double depth_scale, const DisplaceOptions& options, const TriangleSink& sink)
        : relief_(relief), depth_scale_(depth_scale), options_(options), sink_(sink) {
        batch_.reserve(3 * options.batch);
    }

    /// Levels: halvings of the edges ab, bc, ca, on which their other sides agree.
    void add(const Corner& a, const Corner& b, const Corner& c, const std::array<int, 3>& levels) {
        rates_ = rates_of(a, b, c);
        split(a, b, c, levels);
    }
    std::uint64_t finish() {
        if (!batch_.empty()) sink_(batch_);
        batch_.clear();
        return count_;
    }

  private:
    /// Halves the edges that must be, all at once, so that it depends on each edge alone: neighbours do the same.
    void split(const Corner& a, const Corner& b, const Corner& c, const std::array<int, 3>& levels) {
        const auto& [ab, bc, ca] = levels;
        const int halved = (ab > 0) + (bc > 0) + (ca > 0);
        if (halved == 0) return emit(a, b, c);
        // Turn the triangle until ab is halved, and ca is not if one of them is not.
        if (ab == 0 || (halved == 2 && ca > 0)) return split(b, c, a, {bc, ca, ab});
        const Corner m = middle(a, b);
        if (halved == 1) {
            const int mc = inner(m, c);
            split(a, m, c, {ab - 1, mc, ca});
            return split(m, b, c, {ab - 1, bc, mc});
        }
        const Corner n = middle(b, c);
        const int mn = inner(m, n);
        split(m, b, n, {ab - 1, bc - 1, mn});
        if (halved == 3) {
            const Corner o = middle(c, a);
            const int no = inner(n, o), om = inner(o, m);
            split(a, m, o, {ab - 1, om, ca - 1});
            split(o, n, c, {no, bc - 1, ca - 1});
            return split(m, n, o, {mn, no, om});
        }
        // The quad a m n c, along its shorter diagonal.
        if ((n.place - a.place).length2() <= (m.place - c.place).length2()) {
            const int an = inner(a, n);
            split(a, m, n, {ab - 1, mn, an});
            return split(a, n, c, {an, bc - 1, ca});
        }
        const int mc = inner(m, c);
        split(a, m, c, {ab - 1, mc, ca});
        split(m, n, c, {mn, bc - 1, mc});
    }

    int inner(const Corner& a, const Corner& b) const { return halvings(b.place - a.place, options_.longest_edge); }

    void emit(const Corner& a, const Corner& b, const Corner& c) {
        for (const Corner* corner : {&a, &b, &c}) batch_.push_back(displaced(*corner));
        ++count_;
        if (batch_.size() < 3 * options_.batch) return;
        sink_(batch_);
        batch_.clear();
    }

    DisplacedVertex displaced(const Corner& corner) const {
        const double i = std::floor(corner.place.x), j = std::floor(corner.place.y), x = corner.place.x - i, y = corner.place.y - j;
        const Patch patch = relief_.patch(std::int64_t(i), std::int64_t(j));
        const V3d n = corner.normal.normalized();
        const double depth = 1 - patch.height(x, y), length = std::max(corner.normal.length(), 1e-300);
        const TexelGrid& grid = relief_.grid();
        const V2d uv((corner.place.x + 0.5) / grid.width, (corner.place.y + 0.5) / grid.height);

        // Two tangents of the relief over the smooth surface that n stands on.
        const auto flat = [&](const V3d& v) { return v - n * n.dot(v); };
        const auto tangent = [&](const V3d& position, const V3d& normal, double slope) {
            return flat(position) + (n * slope - flat(normal) * (depth / length)) * depth_scale_;
        };
        V3d up = tangent(rates_.position_x, rates_.normal_x, patch.slope(x, y, 1, 0)).cross(tangent(rates_.position_y, rates_.normal_y, patch.slope(x, y, 0, 1)));
        if (up.dot(n) < 0) up = -up;
        if (up.length2() == 0) up = n;
        return {Imath::V3f(corner.position - n * (depth_scale_ * depth)), Imath::V3f(up.normalized()), Imath::V2f(uv)};
    }

    const BilinearSurface& relief_;
    double depth_scale_;
    const DisplaceOptions& options_;
    const TriangleSink& sink_;
    std::vector<DisplacedVertex> batch_;
    std::uint64_t count_ = 0;
    Rates rates_;
};

Corner corner_of(const Mesh& mesh, std::uint32_t v, const TexelGrid& grid, const MeshRelief& how) {
    const Imath::V2f& uv = mesh.uvs[v];
    const double down = mesh.v_down ? double(uv.y) : 1 - double(uv.y);
    return {mesh.positions[v], V3d(mesh.normals[v]), {how.tiles_u * uv.x * grid.width - 0.5, how.tiles_v * down * grid.height - 0.5}};
}

bool is_finite(const Corner& corner) {
    const V3d sum = corner.position + corner.normal;
    return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z) && std::isfinite(corner.place.x + corner.place.y);
}

using Edge = std::pair<std::uint32_t, std::uint32_t>; ///< welded positions, the smaller first

/// The base triangles that are finite, and for every edge the most halvings that one of its sides needs.
struct BaseTriangles {
    std::vector<std::array<Corner, 3>> corners;
    std::vector<std::array<Edge, 3>> edges;
    std::map<Edge, int> levels;
    double triangles = 0; ///< that will be made, about
};

BaseTriangles base_triangles(const Mesh& mesh, const TexelGrid& grid, const MeshRelief& how, double longest) {
    const Weld weld = weld_positions(mesh.positions, 1);
    BaseTriangles base;
    for (const Triangle& t : mesh.triangles) {
        const std::array<Corner, 3> corners{corner_of(mesh, t[0], grid, how), corner_of(mesh, t[1], grid, how), corner_of(mesh, t[2], grid, how)};
        if (!std::all_of(corners.begin(), corners.end(), is_finite)) continue;
        std::array<Edge, 3> edges;
        double finest = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            edges[k] = std::minmax(weld.position_of[t[k]], weld.position_of[t[(k + 1) % 3]]);
            const V2d edge = corners[(k + 1) % 3].place - corners[k].place;
            int& level = base.levels[edges[k]];
            level = std::max(level, halvings(edge, longest));
            finest = std::max(finest, edge.length() / longest);
        }
        base.corners.push_back(corners);
        base.edges.push_back(edges);
        base.triangles += finest * finest;
    }
    return base;
}

} // namespace

Result<std::uint64_t> displace(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const DisplaceOptions& options,
                               const TriangleSink& sink) {
    const BaseTriangles base = base_triangles(mesh, relief.grid(), how, options.longest_edge);
    if (base.triangles > double(options.most_triangles))
        return fail(ErrorCode::budget, "the displaced mesh would have about " + std::to_string(std::uint64_t(std::min(base.triangles, 1e18))) +
                                          " triangles, one for each texel it shows; take a smaller map or fewer repeats");
    Displacer displacer(relief, how.depth_scale, options, sink);
    for (std::size_t t = 0; t < base.corners.size(); ++t) {
        const auto& [a, b, c] = base.corners[t];
        std::array<int, 3> levels;
        for (std::size_t k = 0; k < 3; ++k) levels[k] = base.levels.at(base.edges[t][k]);
        displacer.add(a, b, c, levels);
    }
    return displacer.finish();
}

} // namespace reliefbake

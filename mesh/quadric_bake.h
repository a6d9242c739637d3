#pragma once
// From a mesh to the quadric at each of its vertices: what curved relief rendering bends with.
// a, b: Ouazzani Chahdi et al., 2018/2022 (per-vertex quadrics after Oliveira & Policarpo 2005); c: the term they leave out.

#include "bake/error.h"
#include "mesh/mesh.h"
#include "mesh/surface_fit.h"

#include <string>

namespace reliefbake {

enum class QuadricFit {
    ring,  ///< five terms over the ring, once a position, turned into each vertex's frame
    jet,   ///< CGAL's jets over the ring, in builds that hold CGAL
    paper, ///< a and b alone over the ring in the vertex's own frame, as printed: right only in frames along the principal directions
};

enum class FrameKind {
    automatic, ///< mesh where the file has tangents, else uv where it has texture coordinates, else principal
    uv,        ///< MikkTSpace
    mesh,      ///< the file's own tangents
    principal, ///< x along the direction of strongest curvature: c is 0
};

struct QuadricOptions {
    QuadricFit fit = QuadricFit::ring;       ///< --fit
    FrameKind frame = FrameKind::automatic;  ///< --frame
    bool twist = true; ///< keep c (--terms abc); without it the surface is right only along x and y
    int threads = 0;   ///< 0: as many as the process may use; the bits do not depend on it
};

/// What was found in the mesh and done about it. Counts of vertices are of the input's, less the non-finite ones.
struct QuadricCounts {
    std::size_t vertices = 0, positions = 0, triangles = 0;
    std::size_t non_finite_vertices = 0;   ///< in no ring, quadric 0
    std::size_t non_finite_triangles = 0;  ///< left out: a corner is not finite
    std::size_t degenerate_triangles = 0;  ///< left out: two corners at one position
    std::size_t zero_area_triangles = 0;   ///< no part in normals; their edges still make neighbours
    /// Positions, as PositionFlag names them.
    std::size_t isolated = 0, no_normal = 0, boundary = 0, non_manifold = 0, low_valence = 0, second_ring = 0, short_rank = 0;
    std::size_t made_normals = 0;      ///< vertices whose normal was missing, zero or not finite
    std::size_t against_winding = 0;   ///< vertices whose normal points into the side that triangles show as their back
    std::size_t made_tangents = 0;     ///< vertices that the frame asked for gave no tangent: the principal one
    std::size_t mirrored = 0;          ///< vertices whose texture is mirrored (bitangent sign -1): c has the other sign there
    std::size_t split_vertices = 0;    ///< vertices added because their triangles need several tangents
    std::size_t out_of_range = 0;      ///< quadrics beyond what a float holds: 0
};

struct QuadricBake {
    Mesh mesh;                         ///< with unit normals and tangents, and quadrics; split vertices stand at the end
    std::vector<std::uint32_t> source; ///< for each vertex the one of the input that it copies
    FrameKind frame;                   ///< never automatic
    QuadricCounts counts;
    double residual_rms = 0, residual_max = 0; ///< heights that the fits leave, over their rings' radius
    /// Root of the share of squared curvature that lies in c: what a and b alone would lose.
    double twist_share = 0;
};

/// Errors: usage (`frame` asks for what the mesh lacks). `name` is the file, for messages.
Result<QuadricBake> bake_quadrics(const Mesh& mesh, const QuadricOptions& options, const std::string& name);

} // namespace reliefbake

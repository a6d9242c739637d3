#pragma once
// One way to store a relief and to follow rays over it: what a sweep measures, and what a budget chooses from.

#include "bake/cone.h"
#include "bake/error.h"
#include "shaders-reference/renderer/technique.h"

#include <string>

namespace reliefbake {

/// What is baked. Candidates that share it share its bake.
struct Representation {
    std::string kind = "cone"; ///< as ReliefMapInfo::kind, or "height": depth and normals alone
    int planes = 1;            ///< sectors of an acm, levels of a cone-stack, pieces of cone-pieces
    ConeOptions cone;          ///< family, lookup, metric, cap, tolerance; its threads change nothing
    ConeEncoding encoding = ConeEncoding::sqrt;
    BitDepth bits = BitDepth::unorm16; ///< of every channel
    int level = 0;             ///< mip level that is baked (bake_depth_mips): 0 as fine as the source, each next one half as fine

    bool has_cones() const { return kind != "height"; }
    friend bool operator==(const Representation& a, const Representation& b);
};

/// How rays are followed.
struct March {
    Technique technique = Technique::cone;
    bool exact_finish = false; ///< cone: solve the bilinear patch in the cell reached
    int steps = 30;            ///< at most, or of the linear search; 0 for techniques that take none
    int refinements = 0;       ///< halvings or secants; 0 for techniques that do not refine

    friend bool operator==(const March&, const March&) = default;
};

struct Candidate {
    Representation map;
    March march;

    friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// A word that says all of it and never changes its meaning: letters, digits, '.', '-', '_'; a file's name.
/// E.g. "relaxed_sqrt_16_t0.001_m1_res1_relaxed_n15_r8".
std::string id_of(const Representation& map);
std::string id_of(const March& march);
std::string id_of(const Candidate& candidate);

/// Texels an axis beside the source's: 2^-level.
double resolution_of(const Representation& map);

/// Refuses (usage) what no bake makes, and what the technique does not follow, a few words each.
Result<void> check_candidate(const Candidate& candidate);

/// Bytes of all channels for a texel of the map itself: cones, two of the normal, depth; with max_mip its pyramid of floats, too.
double bytes_per_texel(const Candidate& candidate);

} // namespace reliefbake

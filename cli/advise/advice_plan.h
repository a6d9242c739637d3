#pragma once
// Which candidates a budget is tried with, in order of bytes.

#include "cli/advise/budget.h"
#include "cli/tradeoff/method.h"

#include <functional>
#include <string>
#include <vector>

namespace reliefbake {

/// Where the shader will run: what it follows, and which textures it may filter.
enum class ShaderTarget {
    glsl,    ///< GLSL 3.30: every technique of shaders-reference/glsl; 8, 16 bits, halfs, floats
    glsl_es, ///< GLSL ES 3.00: every technique; 8 bits and halfs: its core neither has 16-bit integers nor filters floats
    hlsl,    ///< what `reliefbake shader --language hlsl` writes: marches over cones without an exact finish; 8, 16 bits, halfs
};

/// One map followed by one technique, for as many rounds as the budget allows, and fewer.
struct Way {
    const Method* method;
    double bytes_per_texel;         ///< of the source, of the map as it will be
    std::vector<Candidate> marches; ///< longest first
};

/// A depth of bits and a mip level: what all techniques of a map see.
struct StoredSurface {
    BitDepth bits;
    int level;

    friend bool operator==(const StoredSurface&, const StoredSurface&) = default;
};
inline StoredSurface surface_of(const Candidate& candidate) { return {candidate.map.bits, candidate.map.level}; }

/// An exact march over the surface, long enough to arrive: what the surface alone loses.
Candidate probe_of(const StoredSurface& surface);

/// Whether no ray is missed by what is promised, and not by measurement alone: its cones have guarantee C, or R under a
/// march that refines (docs/FAMILIES.md), or it marches over the pyramid; at full resolution, where codes are off by 1/510 at most.
bool misses_none(const Candidate& candidate);

struct AdvicePlan {
    std::vector<Way> ways;      ///< by bytes; of equal ones those of a surface together, then as all_methods()
    std::vector<Way> too_large; ///< likewise: those over the budget's bytes
};

/// As Measurement::bytes_per_texel: what the candidate's map takes for each texel of a source of this size.
double source_bytes_per_texel(const Candidate& candidate, int width, int height);

/// Rounds that are tried: `steps`, and the powers of two below it from 64 down to 4.
std::vector<int> march_lengths(int steps);

/// All methods of a sweep by default x 8, 16 bits (halfs where there can be no 16 bits) x resolutions 1, 1/2, 1/4, and floats at full resolution; the tolerance is the bake's default.
/// At 8 bits cones are stored as sqrt, deeper as ratios (docs/STRESS.md, docs/TRADEOFF.md). Techniques that refine spend a third of
/// the rounds on it, at most 8. A budget that allows no missed ray is tried with what misses_none alone. `width`, `height`: of the source, in
/// texels. `can_hold`: what the output allows.
AdvicePlan plan_advice(int width, int height, const Budget& budget, ShaderTarget target, const std::function<bool(const Representation&)>& can_hold);

} // namespace reliefbake

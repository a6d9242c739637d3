#pragma once
// Which candidates a sweep measures.

#include "cli/tradeoff/method.h"

#include <string>
#include <vector>

namespace reliefbake {

/// Values of each axis; the first is the base. Every method meets every number of steps at the base; each further value of another axis
/// is tried with the rest at the base, or with `full` in every combination.
struct SweepAxes {
    std::vector<std::string> methods; ///< words; empty: the default ones (--techniques)
    std::vector<int> steps = {8, 16, 32, 64, 128};   ///< (--steps)
    std::vector<int> refinements = {8, 4};           ///< of methods that refine (--refinements)
    std::vector<ConeEncoding> encodings = {ConeEncoding::sqrt, ConeEncoding::ratio, ConeEncoding::radius, ConeEncoding::normal}; ///< (--encodings)
    std::vector<BitDepth> bits = {BitDepth::unorm16, BitDepth::unorm8, BitDepth::float32}; ///< (--bits)
    std::vector<int> levels = {0, 1, 2};             ///< mip levels (--resolutions 1,0.5,0.25)
    std::vector<float> tolerances = {0.001f, 0.01f, 0.1f}; ///< of cones (--tolerances)
    bool full = false;                               ///< (--full)
};

struct PlannedCandidate {
    const Method* method;
    Candidate candidate;
    bool base; ///< all axes but steps at their base: a point of the method's curve
};

/// Each candidate once, in an order that shares bakes. What an axis does not change for a method is left out.
std::vector<PlannedCandidate> plan_sweep(const SweepAxes& axes);

/// What a baked map allows: `stored` with every technique that follows it, steps and refinements of `axes`.
std::vector<PlannedCandidate> plan_marches(const Representation& stored, const SweepAxes& axes);

} // namespace reliefbake

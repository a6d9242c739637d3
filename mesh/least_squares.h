#pragma once
// Least squares of a few unknowns: rank-revealing, shortest solution where the rank is short.

#include <array>
#include <cstddef>
#include <span>

namespace reliefbake {

constexpr int ring_unknowns = 5;

/// One equation: the unknowns' coefficients, and the right-hand side last.
using Equation = std::array<double, ring_unknowns + 1>;

struct ShortestSolution {
    std::array<double, ring_unknowns> x{}; ///< the least-squares solution; of many, the shortest
    int rank = 0;
    double smallest_pivot = 0;  ///< last accepted pivot over the first: about 1 / condition
    double residual_squared = 0;
};

/// Overwrites `equations`. A column whose rest is shorter than `tolerance` times the first pivot counts as dependent. An
/// unknown of which all coefficients are 0 stays 0. Modified Gram-Schmidt with column pivoting, the right-hand side carried
/// along as a column, which is as stable as Householder's (Björck, Numerical Methods for Least Squares Problems, 2.4).
ShortestSolution solve_shortest(std::span<Equation> equations, double tolerance);

} // namespace reliefbake

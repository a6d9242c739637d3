#include "mesh/least_squares.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace reliefbake;

namespace {

std::vector<Equation> random_equations(std::mt19937& random, int rows, int rank) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Equation> basis(std::size_t(rank), Equation{}), out(std::size_t(rows), Equation{});
    for (Equation& b : basis)
        for (int j = 0; j < ring_unknowns; ++j) b[std::size_t(j)] = uniform(random);
    for (Equation& e : out) {
        for (const Equation& b : basis) {
            const double factor = uniform(random);
            for (int j = 0; j < ring_unknowns; ++j) e[std::size_t(j)] += factor * b[std::size_t(j)];
        }
        e[ring_unknowns] = uniform(random);
    }
    return out;
}

double dot(const Equation& e, const std::array<double, ring_unknowns>& x) {
    double sum = 0;
    for (std::size_t j = 0; j < x.size(); ++j) sum += e[j] * x[j];
    return sum;
}

} // namespace

TEST_CASE("the residual is orthogonal to every column, the solution lies in the rows' span, and the rank is right") {
    std::mt19937 random(3);
    for (int trial = 0; trial < 2000; ++trial) {
        const int rows = 1 + trial % 12, rank = 1 + trial / 12 % ring_unknowns;
        const std::vector<Equation> equations = random_equations(random, rows, rank);
        std::vector<Equation> scratch = equations;
        const ShortestSolution s = solve_shortest(scratch, 1e-9);
        CAPTURE(rows, rank, s.rank);
        REQUIRE(s.rank == std::min(rows, rank));
        double residual = 0;
        std::array<double, ring_unknowns> gradient{};
        for (const Equation& e : equations) {
            const double left = e[ring_unknowns] - dot(e, s.x);
            residual += left * left;
            for (std::size_t j = 0; j < gradient.size(); ++j) gradient[j] += e[j] * left;
        }
        const double size = 1 + std::sqrt(dot({s.x[0], s.x[1], s.x[2], s.x[3], s.x[4], 0}, s.x));
        for (const double g : gradient) REQUIRE(std::fabs(g) < 1e-9 * size);
        REQUIRE(s.residual_squared == Approx(residual).margin(1e-12 * size * size));

        // Shortest: no part of it in the null space, so adding x as a row finds nothing new.
        std::vector<Equation> with_solution = equations;
        Equation row{};
        std::copy(s.x.begin(), s.x.end(), row.begin());
        with_solution.push_back(row);
        REQUIRE(solve_shortest(with_solution, 1e-7).rank <= s.rank);
    }
}

TEST_CASE("unknowns without coefficients stay 0, and nothing at all gives 0") {
    std::vector<Equation> equations{{1, 0, 0, 0, 0, 2}, {1, 1, 0, 0, 0, 3}, {2, 1, 0, 0, 0, 5}};
    const ShortestSolution s = solve_shortest(equations, 1e-9);
    REQUIRE(s.rank == 2);
    REQUIRE(s.x[0] == Approx(2));
    REQUIRE(s.x[1] == Approx(1));
    REQUIRE(s.x[2] == 0);
    REQUIRE(s.x[4] == 0);
    REQUIRE(solve_shortest({}, 1e-9).rank == 0);
    std::vector<Equation> zeros(4, Equation{0, 0, 0, 0, 0, 1});
    REQUIRE(solve_shortest(zeros, 1e-9).rank == 0);
}

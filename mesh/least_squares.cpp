#include "mesh/least_squares.h"

#include <cmath>

namespace reliefbake {

namespace {

constexpr int columns = ring_unknowns + 1, right_hand_side = ring_unknowns;

/// R of Q D R = A P, with ones on R's diagonal, and D^-1 Q' b as its last column: row k belongs to the k-th pivot. Without D's
/// lengths no root is taken.
struct Triangular {
    std::array<std::array<double, columns>, ring_unknowns> row;
    std::array<int, ring_unknowns> pivot;
    int rank = 0;
};

using Columns = std::array<double, columns>;

/// An equation in SIMD registers: written out, since compilers make slow code of six numbers in a row.
struct Pairs {
    using Pair [[gnu::vector_size(16)]] = double;
    Pair a{}, b{}, c{};

    Pairs() = default;
    explicit Pairs(const Equation& e) : a{e[0], e[1]}, b{e[2], e[3]}, c{e[4], e[5]} {}
    Columns numbers() const { return {a[0], a[1], b[0], b[1], c[0], c[1]}; }
    void add_product(const Pairs& x, double factor) { a += x.a * factor, b += x.b * factor, c += x.c * factor; }
    void add_squares(const Pairs& x) { a += x.a * x.a, b += x.b * x.b, c += x.c * x.c; }
};

/// Squared length of each column.
Columns squared_lengths(std::span<const Equation> equations) {
    Pairs sum;
    for (const Equation& e : equations) sum.add_squares(Pairs(e));
    return sum.numbers();
}

/// Takes the pivot's direction out of all columns, those that were pivots too; gives R's row and the squared lengths that are left.
void eliminate(std::span<Equation> equations, int pivot, double squared_length, Columns& row, Columns& left) {
    Pairs dots, r, rest;
    for (const Equation& e : equations) dots.add_product(Pairs(e), e[pivot]);
    r.add_product(dots, 1 / squared_length);
    for (Equation& e : equations) {
        Pairs x(e);
        x.add_product(r, -e[pivot]);
        e = x.numbers();
        rest.add_squares(x);
    }
    row = r.numbers();
    left = rest.numbers();
}

Triangular triangulate(std::span<Equation> equations, double tolerance, ShortestSolution& solution) {
    Triangular r;
    Columns left = squared_lengths(equations);
    std::array<bool, ring_unknowns> used{};
    double first = 0, last = 0;
    for (int k = 0; k < ring_unknowns && k < int(equations.size()); ++k) {
        int pivot = -1;
        for (int j = 0; j < ring_unknowns; ++j)
            if (!used[j] && (pivot < 0 || left[j] > left[pivot])) pivot = j;
        if (k == 0) first = left[pivot];
        if (!(left[pivot] > tolerance * tolerance * first)) break;
        last = left[pivot];
        used[pivot] = true;
        r.pivot[k] = pivot;
        eliminate(equations, pivot, last, r.row[k], left);
        r.rank = k + 1;
    }
    int free = r.rank;
    for (int j = 0; j < ring_unknowns; ++j)
        if (!used[j]) r.pivot[free++] = j;
    solution.rank = r.rank;
    solution.residual_squared = left[right_hand_side];
    solution.smallest_pivot = r.rank > 0 ? std::sqrt(last / first) : 0;
    return r;
}

/// Solves the leading triangle for one column of the rest.
std::array<double, ring_unknowns> substitute_back(const Triangular& r, int column) {
    std::array<double, ring_unknowns> x{};
    for (int k = r.rank - 1; k >= 0; --k) {
        double sum = r.row[k][column];
        for (int m = k + 1; m < r.rank; ++m) sum -= r.row[k][r.pivot[m]] * x[m];
        x[k] = sum;
    }
    return x;
}

using Square = std::array<std::array<double, ring_unknowns + 1>, ring_unknowns>;

/// Gauss without pivoting, for I + N'N, whose pivots are at least 1. The last column holds the right-hand side.
std::array<double, ring_unknowns> solve_definite(Square m, int size) {
    for (int k = 0; k < size; ++k)
        for (int i = k + 1; i < size; ++i) {
            const double factor = m[i][k] / m[k][k];
            for (int j = k; j <= size; ++j) m[i][j] -= factor * m[k][j];
        }
    std::array<double, ring_unknowns> w{};
    for (int k = size - 1; k >= 0; --k) {
        double sum = m[k][size];
        for (int j = k + 1; j < size; ++j) sum -= m[k][j] * w[j];
        w[k] = sum / m[k][k];
    }
    return w;
}

/// All solutions are (u - N w, w) for the free unknowns w; the shortest has (I + N'N) w = N'u.
void shorten(const Triangular& r, std::array<double, ring_unknowns>& u, std::array<double, ring_unknowns>& w) {
    const int free = ring_unknowns - r.rank;
    std::array<std::array<double, ring_unknowns>, ring_unknowns> n;
    for (int j = 0; j < free; ++j) n[j] = substitute_back(r, r.pivot[r.rank + j]);
    const auto dot = [&](const auto& a, const auto& b) {
        double sum = 0;
        for (int k = 0; k < r.rank; ++k) sum += a[k] * b[k];
        return sum;
    };
    Square m{};
    for (int i = 0; i < free; ++i) {
        for (int j = 0; j < free; ++j) m[i][j] = (i == j) + dot(n[i], n[j]);
        m[i][free] = dot(n[i], u);
    }
    w = solve_definite(m, free);
    for (int k = 0; k < r.rank; ++k)
        for (int j = 0; j < free; ++j) u[k] -= n[j][k] * w[j];
}

} // namespace

ShortestSolution solve_shortest(std::span<Equation> equations, double tolerance) {
    ShortestSolution solution;
    const Triangular r = triangulate(equations, tolerance, solution);
    std::array<double, ring_unknowns> u = substitute_back(r, right_hand_side), w{};
    if (r.rank < ring_unknowns) shorten(r, u, w);
    for (int k = 0; k < r.rank; ++k) solution.x[r.pivot[k]] = u[k];
    for (int k = r.rank; k < ring_unknowns; ++k) solution.x[r.pivot[k]] = w[k - r.rank];
    return solution;
}

} // namespace reliefbake

#include "cli/tradeoff/pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace reliefbake {

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
    std::vector<std::size_t> order(points.size()), front;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
    });
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t k : order)
        if (points[k].error < least) least = points[k].error, front.push_back(k);
    return front;
}

} // namespace reliefbake

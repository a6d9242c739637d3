#pragma once
// What nothing else beats.

#include <cstddef>
#include <vector>

namespace reliefbake {

struct CostAndError {
    double cost, error;
};

/// Indices of the points that no other point beats: none has a cost and an error as low, and one of them lower. Of equal points the
/// first. In order of cost.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

} // namespace reliefbake

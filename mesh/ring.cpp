#include "mesh/ring.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

constexpr std::size_t few_corners = 32; ///< up to here a linear look is faster than sorting

std::uint32_t corner_after(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
std::uint32_t corner_before(std::uint32_t k) { return k == 0 ? 2 : k - 1; }

} // namespace

/// The common case, without a branch for each pair: every neighbour is left once and come from once.
bool Ring::take_closed_fan(std::span<const std::uint32_t> after, std::span<const std::uint32_t> before) {
    std::array<std::uint32_t, few_corners> met{};
    std::uint32_t good = 1;
    for (std::size_t i = 0; i < after.size(); ++i) {
        std::uint32_t partners = 0;
        for (std::size_t j = 0; j < before.size(); ++j) {
            const std::uint32_t same = after[i] == before[j];
            partners += same;
            met[j] += same;
        }
        good &= partners == 1;
    }
    for (std::size_t j = 0; j < before.size(); ++j) good &= met[j] == 1;
    if (good) neighbours_.assign(after.begin(), after.end());
    return good;
}

void Ring::add(std::uint32_t neighbour, int direction) {
    for (std::size_t k = 0; k < neighbours_.size(); ++k)
        if (neighbours_[k] == neighbour) {
            ++uses_[k][direction];
            return;
        }
    neighbours_.push_back(neighbour);
    uses_.push_back({direction == 0, direction == 1});
}

/// As `add` for all corners, in n log n.
void Ring::add_many(std::span<const std::uint32_t> corners) {
    sorting_.clear();
    for (const std::uint32_t corner : corners) {
        const Triangle& t = surface_.lists.places[corner / 3];
        sorting_.push_back({t[corner_after(corner % 3)], 0});
        sorting_.push_back({t[corner_before(corner % 3)], 1});
    }
    std::sort(sorting_.begin(), sorting_.end());
    for (const auto& [neighbour, direction] : sorting_) {
        if (neighbours_.empty() || neighbours_.back() != neighbour) {
            neighbours_.push_back(neighbour);
            uses_.push_back({0, 0});
        }
        ++uses_.back()[direction];
    }
}

/// Max's weight of a triangle with the edges a, b at the position: sine of the angle over the product of their lengths.
void Ring::add_normal(const Imath::V3d& a, const Imath::V3d& b, bool first_corner) {
    constexpr double smallest_sine = 1e-12; // below it a double's cross product is mostly rounding
    const Imath::V3d cross = a.cross(b);
    const double lengths = a.dot(a) * b.dot(b);
    if (cross.dot(cross) > smallest_sine * smallest_sine * lengths) normal_ += cross / lengths;
    else zero_area_corners_ += first_corner;
}

void Ring::classify(std::size_t triangles) {
    if (triangles == 0) flags_ |= isolated;
    else if (neighbours_.size() <= 3) flags_ |= low_valence;
    std::size_t ends = 0;
    for (const auto& [leaving, coming] : uses_) {
        if (leaving + coming == 1) ++ends;
        if (leaving > 1 || coming > 1) flags_ |= non_manifold;
    }
    if (ends > 0) flags_ |= boundary;
    if (ends > 2) flags_ |= non_manifold;
    const double length = normal_.length();
    if (length > 0 && std::isfinite(length)) normal_ /= length;
    else normal_ = Imath::V3d(0), flags_ |= no_normal;
}

void Ring::gather(std::uint32_t position) {
    position_ = position;
    neighbours_.clear(), uses_.clear();
    normal_ = Imath::V3d(0), flags_ = 0, zero_area_corners_ = 0;
    const std::span<const std::uint32_t> corners = surface_.lists.at(position);
    const Imath::V3d& here = surface_.points[position];
    std::array<std::uint32_t, few_corners> afters, befores;
    std::size_t count = 0;
    const bool few = corners.size() <= few_corners;
    for (const std::uint32_t corner : corners) {
        const Triangle& t = surface_.lists.places[corner / 3];
        const std::uint32_t k = corner % 3, after = t[corner_after(k)], before = t[corner_before(k)];
        add_normal(surface_.points[after] - here, surface_.points[before] - here, k == 0);
        if (few) afters[count] = after, befores[count++] = before;
    }
    if (!few) {
        add_many(corners);
    } else if (!take_closed_fan(std::span(afters).first(count), std::span(befores).first(count))) {
        for (std::size_t n = 0; n < count; ++n) add(afters[n], 0), add(befores[n], 1);
    }
    classify(corners.size());
}

bool Ring::extend() {
    constexpr std::size_t most_corners = 1024;
    std::size_t total = 0;
    for (const std::uint32_t neighbour : neighbours_) total += surface_.lists.at(neighbour).size();
    if (total > most_corners) return false;
    sorting_.clear();
    for (const std::uint32_t neighbour : neighbours_) {
        sorting_.push_back({neighbour, 0});
        for (const std::uint32_t corner : surface_.lists.at(neighbour))
            for (const std::uint32_t place : surface_.lists.places[corner / 3])
                if (place != position_) sorting_.push_back({place, 0});
    }
    std::sort(sorting_.begin(), sorting_.end());
    neighbours_.clear();
    for (const auto& [neighbour, direction] : sorting_)
        if (neighbours_.empty() || neighbours_.back() != neighbour) neighbours_.push_back(neighbour);
    return true;
}

} // namespace reliefbake

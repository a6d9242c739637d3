#include "cli/scene/map_need.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace reliefbake;

namespace {

MapNeed random_need(std::mt19937& random) {
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    MapNeed need;
    need.cones = SceneCones(below(7));
    need.normals = below(2) == 0 || need.cones == SceneCones::sectors_4 || need.cones == SceneCones::sectors_8;
    need.bits = below(2) == 0 ? BitDepth::unorm8 : BitDepth::unorm16;
    need.level = below(3);
    need.mips = below(2) == 0;
    if (need.normals) need.depth_scale = below(3) == 0 ? 0.2 : 0.1;
    return need;
}

/// The fewest bytes of any partition, tried one by one; `parts`: those so far, joined.
std::uint64_t cheapest_by_trial(const std::vector<MapNeed>& needs, std::size_t next, std::vector<MapNeed>& parts) {
    if (next == needs.size()) {
        std::uint64_t bytes = 0;
        for (const MapNeed& part : parts) bytes += bytes_of(part, 100, 60);
        return bytes;
    }
    std::uint64_t best = ~std::uint64_t(0);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const MapNeed before = parts[k];
        const auto both = joined(before, needs[next]);
        if (!both) continue;
        parts[k] = *both;
        best = std::min(best, cheapest_by_trial(needs, next + 1, parts));
        parts[k] = before;
    }
    parts.push_back(needs[next]);
    best = std::min(best, cheapest_by_trial(needs, next + 1, parts));
    parts.pop_back();
    return best;
}

std::uint64_t bytes_of_parts(const std::vector<MapNeed>& needs) {
    std::uint64_t bytes = 0;
    std::vector<bool> seen(needs.size());
    for (const std::vector<std::size_t>& part : cheapest_maps(needs, 100, 60)) {
        MapNeed whole = needs[part.front()];
        for (const std::size_t k : part) {
            REQUIRE_FALSE(seen[k]);
            seen[k] = true;
            const auto both = joined(whole, needs[k]);
            REQUIRE(both);
            whole = *both;
        }
        bytes += bytes_of(whole, 100, 60);
    }
    CHECK(std::count(seen.begin(), seen.end(), true) == std::ptrdiff_t(needs.size()));
    return bytes;
}

} // namespace

TEST_CASE("a join serves both, and nothing less does") {
    std::mt19937 random(7);
    for (int n = 0; n < 2000; ++n) {
        const MapNeed a = random_need(random), b = random_need(random);
        const auto both = joined(a, b);
        CHECK(joined(b, a) == both);
        CHECK(joined(a, a) == a);
        if (!both) continue;
        CHECK(joined(*both, a) == both);
        CHECK(bytes_of(*both, 64, 64) >= bytes_of(a, 64, 64));
    }
    MapNeed relaxed, open;
    relaxed.cones = SceneCones::relaxed, open.cones = SceneCones::open;
    CHECK_FALSE(joined(relaxed, open)); // ao would read cones that hold the relief
}

TEST_CASE("the partition chosen is the cheapest of all, and needs that are dropped add no bytes") {
    std::mt19937 random(11);
    for (int n = 0; n < 150; ++n) {
        std::vector<MapNeed> needs, none;
        for (int k = 0; k < 1 + n % 6; ++k) needs.push_back(random_need(random));
        const std::uint64_t bytes = bytes_of_parts(needs);
        CHECK(bytes == cheapest_by_trial(needs, 0, none));
        for (std::size_t k = 0; k < needs.size() && needs.size() > 1; ++k) {
            std::vector<MapNeed> fewer = needs;
            fewer.erase(fewer.begin() + std::ptrdiff_t(k));
            CHECK(bytes_of_parts(fewer) <= bytes);
        }
    }
    std::vector<MapNeed> many(most_needs);
    for (std::size_t k = 0; k < many.size(); ++k) many[k].level = int(k);
    CHECK(cheapest_maps(many, 1 << 13, 1 << 13).size() == 1); // the finest serves them all
}

TEST_CASE("bytes are those of every texel of every level") {
    MapNeed need;
    need.normals = true;
    CHECK(bytes_of(need, 8, 4) == 8 * 4 * 3 * 2);
    need.mips = true;
    CHECK(chain_levels(8, 4, 0, true) == 4);
    CHECK(bytes_of(need, 8, 4) == (32 + 8 + 2 + 1) * 3 * 2);
    need.level = 1, need.bits = BitDepth::unorm8, need.cones = SceneCones::cone;
    CHECK(bytes_of(need, 8, 4) == (8 + 2 + 1) * 4);
    CHECK(chain_levels(5, 3, 1, true) == 2);
    need.cones = SceneCones::sectors_8, need.mips = false, need.level = 0;
    CHECK(bytes_of(need, 8, 4) == 32 * 11);
}

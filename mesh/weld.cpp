#include "mesh/weld.h"

#include "bake/parallel.h"
#include "bake/large_array.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

namespace reliefbake {

namespace {

constexpr std::size_t block_vertices = 16384;
constexpr int bucket_bits = 10; ///< small tables that stay in the cache, and work for threads
constexpr std::size_t buckets = std::size_t(1) << bucket_bits;

std::uint64_t hash(const Imath::V3d& p) {
    std::uint64_t h = 0;
    for (const double coordinate : {p.x, p.y, p.z}) {
        h ^= std::bit_cast<std::uint64_t>(coordinate + 0.0); // -0 + 0 is 0
        h *= 0x9e3779b97f4a7c15;
        h ^= h >> 32;
    }
    return h * 0xd6e8feb86659fd93;
}

std::size_t bucket_of(std::uint64_t h) { return h >> (64 - bucket_bits); }

bool is_finite(const Imath::V3d& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

struct Entry {
    std::uint64_t hash;
    std::uint32_t vertex;
};

/// Finite vertices, bucket after bucket, each bucket in the order of its vertices.
struct Buckets {
    LargeArray<Entry> entries;
    std::array<std::size_t, buckets + 1> begin{};
};

Buckets sort_into_buckets(const std::vector<Imath::V3d>& positions, int threads) {
    const std::size_t blocks = (positions.size() + block_vertices - 1) / block_vertices;
    LargeArray<std::uint64_t> hashes(positions.size());
    std::vector<std::array<std::uint32_t, buckets>> counts(blocks);
    const auto each_vertex = [&](int block, const auto& visit) {
        const std::size_t first = std::size_t(block) * block_vertices;
        for (std::size_t v = first; v < std::min(first + block_vertices, positions.size()); ++v)
            if (is_finite(positions[v])) visit(v);
    };
    parallel_for(int(blocks), threads, [&](int block) {
        auto& count = counts[std::size_t(block)];
        count.fill(0);
        each_vertex(block, [&](std::size_t v) { ++count[bucket_of(hashes[v] = hash(positions[v]))]; });
    });

    // Turn counts into the places where each block's share of each bucket begins.
    Buckets out;
    std::size_t total = 0;
    std::vector<std::array<std::size_t, buckets>> places(blocks);
    for (std::size_t b = 0; b < buckets; ++b) {
        out.begin[b] = total;
        for (std::size_t block = 0; block < blocks; ++block) places[block][b] = std::exchange(total, total + counts[block][b]);
    }
    out.begin[buckets] = total;

    out.entries.resize(total);
    parallel_for(int(blocks), threads, [&](int block) {
        auto& place = places[std::size_t(block)];
        each_vertex(block, [&](std::size_t v) { out.entries[place[bucket_of(hashes[v])]++] = {hashes[v], std::uint32_t(v)}; });
    });
    return out;
}

/// Sets first[v] to the first vertex at the place of v, by open addressing.
void find_firsts(std::span<const Entry> entries, const std::vector<Imath::V3d>& positions, std::vector<std::uint32_t>& first) {
    std::vector<Entry> table(std::bit_ceil(2 * entries.size() + 1), Entry{0, no_position});
    const std::size_t mask = table.size() - 1;
    for (const Entry& entry : entries) {
        std::size_t slot = entry.hash & mask;
        while (table[slot].vertex != no_position &&
               (table[slot].hash != entry.hash || positions[table[slot].vertex] != positions[entry.vertex]))
            slot = (slot + 1) & mask;
        if (table[slot].vertex == no_position) table[slot] = entry;
        first[entry.vertex] = table[slot].vertex;
    }
}

} // namespace

Weld weld_positions(const std::vector<Imath::V3d>& positions, int threads) {
    const Buckets sorted = sort_into_buckets(positions, threads);
    Weld weld;
    weld.position_of.assign(positions.size(), no_position);
    parallel_for(int(buckets), threads, [&](int b) {
        const std::span<const Entry> all(sorted.entries);
        const std::size_t begin = sorted.begin[std::size_t(b)], end = sorted.begin[std::size_t(b) + 1];
        find_firsts(all.subspan(begin, end - begin), positions, weld.position_of);
    });

    // Number the places; a place's first vertex comes before its others.
    for (std::size_t v = 0; v < positions.size(); ++v) {
        std::uint32_t& place = weld.position_of[v];
        if (place == no_position) continue;
        if (place == v) {
            place = std::uint32_t(weld.first_vertex.size());
            weld.first_vertex.push_back(std::uint32_t(v));
        } else {
            place = weld.position_of[place];
        }
    }
    return weld;
}

} // namespace reliefbake

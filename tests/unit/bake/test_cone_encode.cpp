#include "bake/cone.h"
#include "bake/stored_code.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <random>

using namespace reliefbake;

namespace {

constexpr ConeEncoding encodings[] = {ConeEncoding::ratio, ConeEncoding::sqrt, ConeEncoding::radius,
                                      ConeEncoding::normal};
constexpr BitDepth depths[] = {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32};

/// One row of cones over one row of depths, on one thread.
struct Row {
    ConeMap cones;
    DepthMap depth;
};

Row make_row(int count, float ratio_max, BitDepth bits) {
    TexelGrid grid;
    grid.width = count;
    Row row{{grid, {}, Image<float>(count, 1, ratio_max)},
            {grid, bits, Image<float>(count, 1, float(max_code(bits)))}};
    row.cones.options.ratio_max = ratio_max;
    row.cones.options.threads = 1;
    return row;
}

EncodedConeMap encode(const Row& row, ConeEncoding encoding, BitDepth bits) {
    return encode_cones(row.cones, row.depth, {encoding, bits});
}

/// The decoder of a shader in IEEE float, given what its sampler returned.
float decode_in_float(float value, float depth, ConeEncoding encoding, float ratio_max) {
    switch (encoding) {
    case ConeEncoding::ratio:
        return value * ratio_max;
    case ConeEncoding::sqrt:
        return value * value * ratio_max;
    case ConeEncoding::radius:
        return depth > 0 ? value / depth : ratio_max;
    case ConeEncoding::normal:
        return value / std::sqrt(1 - value * value);
    }
    return 0;
}

/// decode(encode(c)) <= c in double and in float, and with a sampler that is one float too high inside a
/// unorm range. At depth 0 a radius means the widest cone by definition: nothing lies above the top.
bool law_holds(const EncodedConeMap& map, const Row& row) {
    for (int x = 0; x < map.grid.width; ++x) {
        const float value = map.value(x, 0), ratio = row.cones.ratio(x, 0);
        const double depth = row.depth.depth(x, 0);
        if (map.encoding == ConeEncoding::radius && depth == 0) continue;
        const bool inexact = is_unorm(map.bits) && value > 0 && value < 1;
        const float sampled = inexact ? std::nextafter(value, 1.0f) : value;
        const bool holds = decode_ratio(value, depth, map.encoding, map.ratio_max) <= ratio &&
                           decode_in_float(value, float(depth), map.encoding, map.ratio_max) <= ratio &&
                           decode_in_float(sampled, float(depth), map.encoding, map.ratio_max) <= ratio;
        if (!holds) {
            WARN("encoding " << int(map.encoding) << " bits " << int(map.bits) << " ratio " << ratio
                             << " depth " << depth << " value " << value);
            return false;
        }
    }
    return true;
}

} // namespace

TEST_CASE("decode(encode(c)) <= c for every representable cone, and next to it") {
    const ConeEncoding encoding = GENERATE(from_range(std::begin(encodings), std::end(encodings)));
    const BitDepth bits = GENERATE(from_range(std::begin(depths), std::end(depths)));
    const float ratio_max = GENERATE(1.0f, 0.37f, 5.0f);
    const int count = bits == BitDepth::float32 ? 65536 : int(largest_code(bits));
    Row row = make_row(3 * count, ratio_max, BitDepth::unorm16);
    for (int i = 0; i < count; ++i) {
        const float value =
            bits == BitDepth::float32 ? float(i + 1) / float(count) : stored_value(StoredCode(i + 1), bits);
        const double exact = decode_ratio(std::min(value, 1.0f), 1, encoding, ratio_max);
        const float ratio = std::min(float(exact), ratio_max);
        row.cones.ratio(3 * i, 0) = std::max(std::nextafter(ratio, 0.0f), 1e-30f);
        row.cones.ratio(3 * i + 1, 0) = std::max(ratio, 1e-30f);
        row.cones.ratio(3 * i + 2, 0) = std::max(std::min(std::nextafter(ratio, 1e30f), ratio_max), 1e-30f);
    }
    CHECK(law_holds(encode(row, encoding, bits), row));
}

TEST_CASE("decode(encode(c)) <= c for random cones and depths") {
    for (const ConeEncoding encoding : encodings)
        for (const BitDepth bits : depths) {
            INFO("encoding " << int(encoding) << " bits " << int(bits));
            CHECK(rc::check([&] {
                const auto pattern =
                    *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::arbitrary<std::uint32_t>());
                if (pattern.empty()) return;
                const float ratio_max = float(*rc::gen::inRange(1, 4000)) / 100;
                Row row = make_row(int(pattern.size()), ratio_max, bits);
                for (int i = 0; i < int(pattern.size()); ++i) {
                    // Exponents spread evenly: cones from 2^-30 of the widest to the widest.
                    const double fraction = (pattern[i] >> 8) / double(1 << 24);
                    row.cones.ratio(i, 0) = std::min(float(ratio_max * std::exp2(-30 * fraction)), ratio_max);
                    const StoredCode level = is_unorm(bits) ? pattern[i] % (max_code(bits) + 1) : 0;
                    row.depth.level(i, 0) =
                        is_unorm(bits) ? float(level)
                                       : stored_value(nearest_code((pattern[i] & 255) / 255.0, bits), bits);
                }
                RC_ASSERT(law_holds(encode(row, encoding, bits), row));
            }));
        }
}

TEST_CASE("The code taken is the widest: the next one breaks the law by more than rounding") {
    std::mt19937 random(11);
    for (const ConeEncoding encoding : encodings) {
        Row row = make_row(4096, 1, BitDepth::unorm16);
        for (int i = 0; i < 4096; ++i) {
            row.cones.ratio(i, 0) = float((random() % 65536 + 1) / 65536.0);
            row.depth.level(i, 0) = float(random() % 65536);
        }
        const EncodedConeMap map = encode(row, encoding, BitDepth::unorm16);
        for (int i = 0; i < 4096; ++i) {
            const StoredCode next = nearest_code(map.value(i, 0), map.bits) + 1;
            const double depth = row.depth.depth(i, 0);
            if (next > largest_code(map.bits) || depth == 0) continue;
            const double wider = decode_ratio(stored_value(next, map.bits), depth, encoding, 1);
            CHECK(wider > double(row.cones.ratio(i, 0)) * (1 - 1e-4));
        }
    }
}

TEST_CASE("The widest cone is exact where its code is") {
    for (const BitDepth bits : depths)
        for (const ConeEncoding encoding : {ConeEncoding::ratio, ConeEncoding::sqrt})
            for (const float ratio_max : {1.0f, 0.3f, 7.0f}) {
                const EncodedConeMap map = encode(make_row(4, ratio_max, bits), encoding, bits);
                CHECK(map.value(0, 0) == 1);
                CHECK(map.zero_codes == 0);
            }
}

TEST_CASE("Unbounded cones: a normal of 1, a finite radius") {
    const float inf = std::numeric_limits<float>::infinity();
    for (const BitDepth bits : depths) {
        Row row = make_row(2, inf, bits);
        row.cones.ratio(1, 0) = 1e30f;
        const EncodedConeMap normal = encode(row, ConeEncoding::normal, bits);
        CHECK(normal.value(0, 0) == 1);
        CHECK(normal.value(1, 0) < 1);
        if (is_unorm(bits)) continue;
        CHECK(encode(row, ConeEncoding::radius, bits).value(0, 0) == 65504);
    }
}

TEST_CASE("Code 0 is taken only where code 1 is too wide, and counted but for a radius at depth 0") {
    Row row = make_row(3, 1, BitDepth::unorm8);
    const float smallest[] = {1.0f / 255, 0.9f / 255, 0.5f};
    for (int i = 0; i < 3; ++i)
        row.cones.ratio(i, 0) = smallest[i];
    const EncodedConeMap ratio = encode(row, ConeEncoding::ratio, BitDepth::unorm8);
    CHECK(ratio.value(1, 0) == 0);
    CHECK(ratio.value(2, 0) > 0);
    CHECK(encode(row, ConeEncoding::sqrt, BitDepth::unorm8).zero_codes == 0);
    row.depth.level(2, 0) = 0;
    const EncodedConeMap radius = encode(row, ConeEncoding::radius, BitDepth::unorm8);
    CHECK(radius.value(2, 0) == 0);
    CHECK(radius.zero_codes == std::size_t(radius.value(0, 0) == 0) + 1);
}

TEST_CASE("The same codes for every thread count") {
    TexelGrid grid;
    grid.width = 37;
    grid.height = 29;
    ConeMap cones{grid, {}, Image<float>(37, 29)};
    DepthMap depth{grid, BitDepth::unorm16, Image<float>(37, 29)};
    std::mt19937 random(5);
    for (float& ratio : cones.ratio)
        ratio = float((random() % 1000 + 1) / 1000.0);
    for (float& level : depth.level)
        level = float(random() % 65536);
    cones.options.threads = 1;
    const EncodedConeMap one = encode_cones(cones, depth, {ConeEncoding::radius, BitDepth::unorm8});
    cones.options.threads = 3;
    const EncodedConeMap three = encode_cones(cones, depth, {ConeEncoding::radius, BitDepth::unorm8});
    CHECK(one.value == three.value);
    CHECK(one.zero_codes == three.zero_codes);
}

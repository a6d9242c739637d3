#include "formats/image_gate.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace reliefbake;

namespace {
constexpr std::uint64_t mib = 1ull << 20, gib = 1ull << 30;

ImageClaims claims(std::int64_t width, std::int64_t height, int channels, SampleType sample) {
    ImageClaims c;
    c.width = width;
    c.height = height;
    c.sample = sample;
    for (int i = 0; i < channels; ++i) c.channels.push_back(std::to_string(i));
    return c;
}

bool passes(const ImageClaims& c, std::uint64_t file_bytes, std::uint64_t max_bytes = 0, int planes = 1) {
    const Result<void> result = check_claims(c, file_bytes, max_bytes, planes, "x");
    if (!result) {
        CHECK(result.error().code == ErrorCode::bad_data);
        CHECK(result.error().message.starts_with("x: "));
        CHECK(result.error().message.find('\n') == std::string::npos);
    }
    return bool(result);
}
} // namespace

TEST_CASE("budget: 1 GiB, 1000 x the file above 64 MiB, or what the user says") {
    CHECK(decode_budget(0, 0) == 64 * mib);
    CHECK(decode_budget(100'000, 0) == 100'000'000);
    CHECK(decode_budget(std::numeric_limits<std::uint64_t>::max(), 0) == gib);
    CHECK(decode_budget(1, 5 * gib) == 5 * gib);
}

TEST_CASE("the largest honest map passes, one more row does not") {
    CHECK(passes(claims(16384, 16384, 1, SampleType::uint16), 30 * mib));
    CHECK_FALSE(passes(claims(16384, 16385, 1, SampleType::uint16), 30 * mib));
    CHECK(passes(claims(16384, 16385, 1, SampleType::uint16), 30 * mib, 2 * gib));
    CHECK_FALSE(passes(claims(16384, 16384, 1, SampleType::uint16), 30 * mib, 0, 4));
    CHECK(passes(claims(8192, 8192, 4, SampleType::uint16), 30 * mib, 0, 4));
}

TEST_CASE("products do not overflow") {
    ImageClaims c = claims(65536, 65536, 1024, SampleType::float64);
    CHECK(decoded_bytes(c) == (1ull << 45));
    c.tile_width = c.tile_height = std::numeric_limits<std::int64_t>::max();
    CHECK(decoded_bytes(c) == std::numeric_limits<std::uint64_t>::max());
    CHECK_FALSE(passes(c, gib, std::numeric_limits<std::uint64_t>::max() - 1));
}

TEST_CASE("sizes, kinds and channels that no map has") {
    CHECK_FALSE(passes(claims(0, 5, 1, SampleType::uint8), 100));
    CHECK_FALSE(passes(claims(5, -5, 1, SampleType::uint8), 100));
    CHECK_FALSE(passes(claims(65537, 1, 1, SampleType::uint8), 100));
    CHECK_FALSE(passes(claims(5, 5, 0, SampleType::uint8), 100));
    CHECK_FALSE(passes(claims(1, 1, 1025, SampleType::uint8), 100));
    ImageClaims deep = claims(5, 5, 1, SampleType::uint8);
    deep.deep = true;
    CHECK_FALSE(passes(deep, 100));
    ImageClaims volume = claims(5, 5, 1, SampleType::uint8);
    volume.depth = 2;
    CHECK_FALSE(passes(volume, 100));
}

#include "formats/map_json.h"
#include "formats/shortest_decimal.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using namespace reliefbake;

namespace {
ReliefMapInfo sample_info() {
    ReliefMapInfo info;
    info.metric = Metric::l1;
    info.encoding = ConeEncoding::radius;
    info.bits = BitDepth::half;
    info.surface = SurfaceModel::texel;
    info.layout = ChannelLayout::named;
    info.normal_y = NormalY::dx;
    info.cone_max = 0.3f;
    info.depth_scale = 0.07;
    info.filter_delta = 1.0 / 512;
    info.tolerance = 0.001;
    info.guarantee = "C";
    info.version = "0.1.0";
    info.source_hash = "00ff";
    info.argument_hash = "ff00";
    info.statistics = {{"zero_codes", 3}, {"ratio_mean", 0.1}};
    return info;
}
} // namespace

TEST_CASE("metadata comes back as it went") {
    const ReliefMapInfo info = sample_info();
    const TexelGrid grid{640, 480, Wrap::clamp, Wrap::repeat, 0.7};
    const MapMetadata back = map_metadata_from(to_json(info, grid).dump());
    CHECK(back.bad_keys.empty());
    CHECK(back.metric == info.metric);
    CHECK(back.encoding == info.encoding);
    CHECK(back.surface == info.surface);
    CHECK(back.normal_y == info.normal_y);
    CHECK(back.wrap_x == grid.wrap_x);
    CHECK(back.wrap_y == grid.wrap_y);
    CHECK(back.cone_max == info.cone_max);
    CHECK(back.depth_scale == info.depth_scale);
    CHECK(back.pixel_aspect == grid.pixel_aspect);
    CHECK(back.filter_delta == info.filter_delta);
    CHECK(back.tolerance == info.tolerance);
    CHECK(back.guarantee == info.guarantee);
    CHECK(back.source_hash == info.source_hash);
    CHECK(back.statistics == info.statistics);
    CHECK(back.channels == std::vector<std::string>{"relief.nx", "relief.ny", "relief.cone", "relief.depth"});
}

TEST_CASE("the family of the cones comes back, and its absence means the defaults") {
    ReliefMapInfo info = sample_info();
    info.kind = "acm";
    info.planes = 8;
    info.family = ConeFamily::hybrid;
    info.rays = RelaxedRays::slope;
    info.relaxed_slope = 1.5;
    info.hybrid_delta = 0.25;
    info.lookup = ConeLookup::cell;
    info.levels = 9;
    info.trilinear = true;
    const MapMetadata back = map_metadata_from(to_json(info, {}).dump());
    CHECK(back.bad_keys.empty());
    CHECK(back.kind == "acm");
    CHECK(back.planes == 8);
    CHECK(back.family == ConeFamily::hybrid);
    CHECK(back.rays == RelaxedRays::slope);
    CHECK(back.relaxed_slope == 1.5);
    CHECK(back.hybrid_delta == 0.25);
    CHECK(back.lookup == ConeLookup::cell);
    CHECK(back.layout == ChannelLayout::named);
    CHECK(back.levels == 9);
    CHECK(back.trilinear == true);
    CHECK(back.channels->size() == 11);

    const auto plain = to_json(sample_info(), {});
    CHECK(plain["family"] == "conservative");
    for (const char* key : {"relaxed", "relaxed_slope", "hybrid_delta", "planes", "levels", "trilinear"})
        CHECK_FALSE(plain.contains(key));
    const MapMetadata old = map_metadata_from(R"({"kind":"cone","metric":"l2"})");
    CHECK(old.bad_keys.empty());
    CHECK_FALSE(old.family);
}

TEST_CASE("an infinite cap survives") {
    ReliefMapInfo info = sample_info();
    info.cone_max = std::numeric_limits<float>::infinity();
    const auto json = to_json(info, {});
    CHECK(json["cone_max"] == "inf");
    CHECK(map_metadata_from(json.dump()).cone_max == info.cone_max);
}

TEST_CASE("an infinite statistic survives") {
    ReliefMapInfo info = sample_info();
    info.statistics["ratio_mean"] = std::numeric_limits<double>::infinity();
    const auto json = to_json(info, {});
    CHECK(json["statistics"]["ratio_mean"] == "inf");
    CHECK(map_metadata_from(json.dump()).statistics == info.statistics);
}

TEST_CASE("floats are told by their shortest digits, and come back") {
    CHECK(shortest_decimal(0.001f) == 0.001);
    CHECK(to_json(sample_info(), {})["cone_max"] == 0.3);
    CHECK(std::isinf(shortest_decimal(std::numeric_limits<float>::infinity())));
    std::mt19937 random(1);
    for (int i = 0; i < 100'000; ++i) {
        const float value = std::bit_cast<float>(std::uint32_t(random()));
        if (std::isfinite(value)) REQUIRE(float(shortest_decimal(value)) == value);
    }
}

TEST_CASE("malicious values are named, never believed") {
    const auto bad = [](const std::string& text) { return map_metadata_from(text).bad_keys; };
    CHECK(bad(R"({"metric":1})") == std::vector<std::string>{"metric"});
    CHECK(bad(R"({"metric":"l3"})") == std::vector<std::string>{"metric"});
    CHECK(bad(R"({"cone_max":-1})") == std::vector<std::string>{"cone_max"});
    CHECK(bad(R"({"cone_max":0})") == std::vector<std::string>{"cone_max"});
    CHECK(bad(R"({"cone_max":1e300})") == std::vector<std::string>{"cone_max"});
    CHECK(bad(R"({"cone_max":"nan"})") == std::vector<std::string>{"cone_max"});
    CHECK(bad(R"({"cone_max":null})") == std::vector<std::string>{"cone_max"});
    CHECK(bad(R"({"pixel_aspect":0})") == std::vector<std::string>{"pixel_aspect"});
    CHECK(bad(R"({"wrap":["repeat"]})") == std::vector<std::string>{"wrap"});
    CHECK(bad(R"({"wrap":["repeat",7]})") == std::vector<std::string>{"wrap"});
    CHECK(bad(R"({"channels":["R","G"]})") == std::vector<std::string>{"channels"});
    CHECK(bad(R"({"statistics":[]})") == std::vector<std::string>{"statistics"});
    CHECK(bad(R"({"family":"lax"})") == std::vector<std::string>{"family"});
    CHECK(bad(R"({"relaxed":1})") == std::vector<std::string>{"relaxed"});
    CHECK(bad(R"({"hybrid_delta":2})") == std::vector<std::string>{"hybrid_delta"});
    CHECK(bad(R"({"planes":2.5})") == std::vector<std::string>{"planes"});
    CHECK(bad(R"({"planes":1e9})") == std::vector<std::string>{"planes"});
    CHECK(bad(R"({"levels":0})") == std::vector<std::string>{"levels"});
    CHECK(bad(R"({"trilinear":1})") == std::vector<std::string>{"trilinear"});
    CHECK(bad(R"({"layout":"heap"})") == std::vector<std::string>{"layout"});
    CHECK(bad(R"({"kind":{}})") == std::vector<std::string>{"kind"});
    CHECK(bad("[]").empty());
    CHECK(bad("").empty());
    CHECK(bad(std::string(100'000, '[')).empty());
    CHECK(bad("{\"metric\":" + std::string(100'000, '{')).empty());
}

TEST_CASE("every truncation and many mutations are read without harm") {
    const std::string whole = to_json(sample_info(), {}).dump();
    for (std::size_t length = 0; length < whole.size(); ++length) CHECK_FALSE(map_metadata_from(whole.substr(0, length)).metric);
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        std::string text = whole;
        for (int k = 0; k < 3; ++k) text[random() % text.size()] = char(random());
        const MapMetadata metadata = map_metadata_from(text);
        if (metadata.cone_max) CHECK(*metadata.cone_max > 0);
        if (metadata.depth_scale) CHECK(std::isfinite(*metadata.depth_scale));
    }
}

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

#include "formats/map_file.h"
#include "formats/map_json.h"
#include "formats/write_image.h"

#include "png_oracle.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cstring>
#include <limits>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

/// The float that the half with these bits stands for (IEEE 754 binary16).
float half_value(std::uint16_t bits) {
    const int exponent = bits >> 10 & 31;
    const float mantissa = float(bits & 1023);
    const float magnitude = exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
    return bits & 0x8000 ? -magnitude : magnitude;
}

/// Value number k of the values a channel of this depth can hold in [0,1].
float value_of(BitDepth bits, std::size_t k) {
    switch (bits) {
    case BitDepth::unorm8: return float(k % 256) / 255.0f;
    case BitDepth::unorm16: return float(k % 65536) / 65535.0f;
    case BitDepth::half: return half_value(std::uint16_t(k % 0x3c01)); // 0 .. 1, denormals included
    case BitDepth::float32: return std::bit_cast<float>(std::uint32_t(k % 65536) * 16256u); // 0 .. just below 1
    }
    return 0;
}

/// 256 x 256 texels: every 8- and 16-bit code and every half in [0,1] occurs in every channel, beside other codes in the
/// other channels, depth 0 included.
ReliefMap map_of_every_code(BitDepth bits, ChannelLayout layout) {
    ReliefMap map;
    map.info.bits = bits;
    map.info.layout = layout;
    map.info.cone_max = std::numeric_limits<float>::infinity();
    map.info.guarantee.assign(1, 'C');
    map.info.statistics = {{"zero_codes", 0}, {"ratio_mean", 1.0 / 3}};
    map.grid = {256, 256, Wrap::repeat, Wrap::clamp, 1.25};
    Image<float>* planes[] = {&map.normal_x, &map.normal_y, &map.cone, &map.depth};
    const std::size_t steps[] = {1, 3, 7, 257}; // odd: every code occurs; 257 k mod 256 = k, k mod 65536 permuted
    for (int c = 0; c < 4; ++c) {
        *planes[c] = Image<float>(256, 256);
        for (std::size_t k = 0; k < 65536; ++k) (*planes[c])[k] = value_of(bits, k * steps[c] + k / 256);
    }
    return map;
}

struct Variant {
    const char* name;
    BitDepth bits;
    ChannelLayout layout = ChannelLayout::rgba;
};
const Variant variants[] = {
    {"m8.png", BitDepth::unorm8},   {"m16.png", BitDepth::unorm16},   {"m8.tif", BitDepth::unorm8},
    {"m16.tif", BitDepth::unorm16}, {"mh.tif", BitDepth::half},       {"mf.tiff", BitDepth::float32},
    {"mh.exr", BitDepth::half},     {"mf.exr", BitDepth::float32},    {"nh.exr", BitDepth::half, ChannelLayout::named},
    {"m8.tga", BitDepth::unorm8},   {"nf.exr", BitDepth::float32, ChannelLayout::named},
};

MapHints all_hints() {
    MapHints hints;
    hints.metric = Metric::l2;
    hints.encoding = ConeEncoding::sqrt;
    hints.surface = SurfaceModel::bilinear;
    hints.wrap_x = Wrap::repeat;
    hints.wrap_y = Wrap::clamp;
    hints.cone_max = std::numeric_limits<float>::infinity();
    hints.channel_order = "RGBA";
    return hints;
}

bool is_targa(const Variant& v) { return std::strstr(v.name, ".tga"); }

} // namespace

TEST_CASE("every format and depth returns every code of every channel") {
    TemporaryFolder folder;
    for (const Variant& v : variants) {
        CAPTURE(v.name);
        const ReliefMap map = map_of_every_code(v.bits, v.layout);
        REQUIRE(write_map(folder / v.name, map));
        const Result<ReliefMap> back = read_map(folder / v.name, is_targa(v) ? all_hints() : MapHints{});
        REQUIRE(back);
        CHECK(back->normal_x == map.normal_x);
        CHECK(back->normal_y == map.normal_y);
        CHECK(back->cone == map.cone);
        CHECK(back->depth == map.depth);
        if (is_targa(v)) continue;
        CHECK(back->grid == map.grid);
        CHECK(to_json(back->info, back->grid) == to_json(map.info, map.grid));
    }
    CHECK(folder.entries() == std::ssize(variants));
}

TEST_CASE("libpng reads the same codes, and no colour tag") {
    TemporaryFolder folder;
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16}) {
        const ReliefMap map = map_of_every_code(bits, ChannelLayout::rgba);
        REQUIRE(write_map(folder / "m.png", map));
        const RawPng raw = decode_with_libpng(folder / "m.png");
        CHECK(raw.channels == 4);
        CHECK(raw.bits == (bits == BitDepth::unorm8 ? 8 : 16));
        CHECK_FALSE(raw.tagged);
        const Image<float>* planes[] = {&map.normal_x, &map.normal_y, &map.cone, &map.depth};
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < raw.codes.size(); ++i)
            wrong += float(raw.codes[i]) / float(max_code(bits)) != (*planes[i % 4])[i / 4];
        CHECK(wrong == 0);
    }
}

TEST_CASE("a rendered picture keeps its colours under any alpha") {
    TemporaryFolder folder;
    for (int channels = 1; channels <= 4; ++channels) {
        std::vector<std::uint8_t> samples(std::size_t(64 * 16 * channels));
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::uint8_t(i * 7 + i / 256);
        REQUIRE(write_png(folder / "p.png", 64, 16, channels, samples));
        const RawPng raw = decode_with_libpng(folder / "p.png");
        CHECK(raw.width == 64);
        CHECK(raw.height == 16);
        CHECK_FALSE(raw.tagged);
        CHECK(std::equal(samples.begin(), samples.end(), raw.codes.begin(), raw.codes.end()));
    }
}

TEST_CASE("formats refuse what they cannot hold, before any work") {
    const auto refused = [](const char* name, BitDepth bits, ChannelLayout layout = ChannelLayout::rgba) {
        const Result<void> result = check_map_format(name, bits, layout);
        return !result && result.error().code == ErrorCode::usage;
    };
    for (const Variant& v : variants) CHECK(check_map_format(v.name, v.bits, v.layout));
    CHECK(check_map_format("A.PNG", BitDepth::unorm8, ChannelLayout::rgba));
    CHECK(refused("a.png", BitDepth::half));
    CHECK(refused("a.exr", BitDepth::unorm8));
    CHECK(refused("a.tga", BitDepth::unorm16));
    CHECK(refused("a.png", BitDepth::unorm8, ChannelLayout::named));
    CHECK(refused("a.jpg", BitDepth::unorm8));
    CHECK(refused("a", BitDepth::unorm8));
}

TEST_CASE("a map that does not say how to read it names the flags that would") {
    TemporaryFolder folder;
    REQUIRE(write_map(folder / "m.tga", map_of_every_code(BitDepth::unorm8, ChannelLayout::rgba)));
    const Result<ReliefMap> silent = read_map(folder / "m.tga");
    REQUIRE_FALSE(silent);
    CHECK(silent.error().code == ErrorCode::bad_data);
    for (const char* flag : {"--channel-order", "--metric", "--encoding", "--surface", "--wrap", "--cone-max"})
        CHECK(silent.error().message.find(flag) != std::string::npos);

    MapHints normal = all_hints();
    normal.encoding = ConeEncoding::normal;
    normal.cone_max.reset();
    CHECK(read_map(folder / "m.tga", normal));
    CHECK(read_map(folder / "missing.tga").error().code == ErrorCode::no_input);
}

TEST_CASE("channels may be reordered, left out, or hold height") {
    TemporaryFolder folder;
    const ReliefMap map = map_of_every_code(BitDepth::unorm16, ChannelLayout::rgba);
    REQUIRE(write_map(folder / "m.png", map));
    MapHints hints;
    hints.channel_order = "--AG";
    hints.alpha_is_height = true;
    const Result<ReliefMap> back = read_map(folder / "m.png", hints);
    REQUIRE(back);
    CHECK(back->normal_x.empty());
    CHECK(back->normal_y.empty());
    CHECK(back->cone == map.depth);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < map.depth.size(); ++i)
        wrong += back->depth[i] != (65535 - std::round(map.normal_y[i] * 65535)) / 65535.0f;
    CHECK(wrong == 0);

    for (const char* order : {"RGB", "RGBX", "----", "RGBAA"}) {
        hints.channel_order = order;
        CHECK(read_map(folder / "m.png", hints).error().code == ErrorCode::usage);
    }
    hints.channel_order = "RGBY";
    CHECK(read_map(folder / "m.png", hints).error().code == ErrorCode::bad_data);
}

TEST_CASE("damaged metadata and values that mean nothing are bad data") {
    TemporaryFolder folder;
    ReliefMap map = map_of_every_code(BitDepth::float32, ChannelLayout::rgba);
    map.info.depth_scale = -1;
    REQUIRE(write_map(folder / "m.exr", map));
    CHECK(read_map(folder / "m.exr").error().message.find("depth_scale") != std::string::npos);
    MapHints hints;
    hints.depth_scale = 0.1;
    CHECK(read_map(folder / "m.exr", hints));

    map.info.depth_scale = 0.1;
    map.depth[77] = 1.5f;
    REQUIRE(write_map(folder / "m.exr", map));
    CHECK(read_map(folder / "m.exr").error().code == ErrorCode::bad_data);
    map.depth[77] = 1;
    map.cone[5] = std::numeric_limits<float>::quiet_NaN();
    REQUIRE(write_map(folder / "m.exr", map));
    CHECK(read_map(folder / "m.exr").error().code == ErrorCode::bad_data);
}

TEST_CASE("Maps that leave planes out keep the others bit for bit, in one, two or three channels") {
    TemporaryFolder folder;
    for (const HeldPlanes held : {HeldPlanes{false, false}, HeldPlanes{false, true}, HeldPlanes{true, false}})
        for (const Variant& variant : variants) {
            const std::string path = (folder / variant.name).string();
            ReliefMap map = map_of_every_code(variant.bits, variant.layout);
            map.info.held = held;
            if (!held.normals) map.normal_x = {}, map.normal_y = {};
            if (!held.cones) map.cone = {}, map.info.guarantee.clear();
            const bool targa = std::string(variant.name) == "m8.tga";
            const Result<void> written = write_map(path, map);
            INFO(variant.name << ", normals " << held.normals << ", cones " << held.cones);
            if (targa && !held.normals && held.cones) { // no such TGA
                CHECK_FALSE(written);
                continue;
            }
            REQUIRE(written);
            MapHints hints;
            if (targa) hints = all_hints(), hints.channel_order = held.normals ? "RG-B" : "---Y";
            const Result<ReliefMap> back = read_map(path, hints);
            if (!back) FAIL(back.error().message);
            CHECK(back->normal_x == map.normal_x);
            CHECK(back->normal_y == map.normal_y);
            CHECK(back->cone == map.cone);
            CHECK(back->depth == map.depth);
            if (!targa) CHECK(back->info.held == held);
        }
}

// Maps with several cones a texel: every layout returns every plane, and depth and normals come from a relief file.

#include "formats/map_file.h"
#include "formats/map_json.h"
#include "formats/map_layout.h"

#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr int width = 37, height = 21; // odd, and no two alike

/// Values that the depth can hold exactly: multiples of 1/255 or of 1/256, never the same in two planes.
Image<float> plane_of_codes(BitDepth bits, int seed) {
    Image<float> plane(width, height);
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const int code = int((i * 7 + i / 256 + std::size_t(seed) * 31) % 256);
        plane[i] = bits == BitDepth::unorm8    ? float(code) / 255.0f
                   : bits == BitDepth::unorm16 ? float(code * 257) / 65535.0f
                                               : float(code) / 256.0f;
    }
    return plane;
}

ReliefMap some_map(const char* kind, int planes, ChannelLayout layout, BitDepth bits) {
    ReliefMap map;
    map.info.kind = kind;
    map.info.planes = planes;
    map.info.layout = layout;
    map.info.bits = bits;
    map.info.family = ConeFamily::hybrid;
    map.info.rays = RelaxedRays::slope;
    map.info.relaxed_slope = 0.25;
    map.info.hybrid_delta = 0.125;
    map.info.lookup = ConeLookup::cell;
    map.info.source_hash = "00ff";
    map.grid = {width, height, Wrap::repeat, Wrap::clamp, 1.25};
    map.normal_x = plane_of_codes(bits, 1);
    map.normal_y = plane_of_codes(bits, 2);
    map.depth = plane_of_codes(bits, 3);
    if (!has_cone_planes(kind)) map.cone = plane_of_codes(bits, 4);
    for (int k = 0; k < planes; ++k) map.cone_planes.push_back(plane_of_codes(bits, 10 + k));
    return map;
}

ReliefMap relief_of(const ReliefMap& map) {
    ReliefMap relief = map;
    relief.info.kind = "cone";
    relief.info.planes = 0;
    relief.info.layout = ChannelLayout::rgba;
    relief.cone_planes.clear();
    relief.cone = map.depth;
    return relief;
}

struct Case {
    const char* name;
    const char* kind;
    int planes;
    ChannelLayout layout;
    BitDepth bits;
};
const Case cases[] = {
    {"a.png", "acm", 4, ChannelLayout::rgba, BitDepth::unorm8},   {"b.png", "acm", 4, ChannelLayout::rgba, BitDepth::unorm16},
    {"c.tif", "acm", 4, ChannelLayout::rgba, BitDepth::half},     {"d.exr", "acm", 4, ChannelLayout::rgba, BitDepth::float32},
    {"e.exr", "acm", 4, ChannelLayout::named, BitDepth::half},    {"f.exr", "acm", 8, ChannelLayout::named, BitDepth::float32},
    {"g.png", "acm", 8, ChannelLayout::side, BitDepth::unorm8},   {"h.tif", "acm", 8, ChannelLayout::side, BitDepth::unorm16},
    {"i.exr", "acm", 8, ChannelLayout::side, BitDepth::half},     {"j.tif", "acm", 8, ChannelLayout::side, BitDepth::float32},
    {"k.png", "acm", 8, ChannelLayout::pair, BitDepth::unorm8},   {"l.png", "acm", 8, ChannelLayout::pair, BitDepth::unorm16},
    {"m.exr", "acm", 8, ChannelLayout::pair, BitDepth::half},     {"n.tif", "acm", 8, ChannelLayout::pair, BitDepth::float32},
    {"o.png", "cone-stack", 1, ChannelLayout::rgba, BitDepth::unorm8},
    {"p.tif", "cone-stack", 3, ChannelLayout::rgba, BitDepth::unorm16},
    {"q.exr", "cone-stack", 4, ChannelLayout::rgba, BitDepth::half},
    {"r.exr", "cone-stack", 6, ChannelLayout::named, BitDepth::float32},
    {"s.png", "cone-pieces", 3, ChannelLayout::rgba, BitDepth::unorm8},
    {"t.exr", "cone-pieces", 5, ChannelLayout::named, BitDepth::half},
};

} // namespace

TEST_CASE("every layout and depth returns every plane, with its own relief or another file's") {
    TemporaryFolder folder;
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const ReliefMap map = some_map(c.kind, c.planes, c.layout, c.bits);
        REQUIRE(write_map(folder / c.name, map));
        MapHints hints;
        if (!holds_relief(map.info)) {
            hints.relief = folder / (c.bits == BitDepth::unorm8 || c.bits == BitDepth::unorm16 ? "relief.png" : "relief.exr");
            REQUIRE(write_map(hints.relief, relief_of(map)));
        }
        const Result<ReliefMap> back = read_map(folder / c.name, hints);
        REQUIRE(back);
        CHECK(back->normal_x == map.normal_x);
        CHECK(back->normal_y == map.normal_y);
        CHECK(back->depth == map.depth);
        CHECK(back->cone.empty());
        CHECK(back->cone_planes == map.cone_planes);
        CHECK(back->grid == map.grid);
        CHECK(to_json(back->info, back->grid) == to_json(map.info, map.grid));
    }
}

TEST_CASE("a map of cones alone asks for its relief, and takes only the one it was baked for") {
    TemporaryFolder folder;
    const ReliefMap map = some_map("acm", 4, ChannelLayout::rgba, BitDepth::unorm16);
    REQUIRE(write_map(folder / "m.png", map));
    const auto without = read_map(folder / "m.png");
    REQUIRE_FALSE(without);
    CHECK(without.error().code == ErrorCode::usage);
    CHECK(without.error().message.find("--relief") != std::string::npos);

    MapHints hints;
    hints.cones_suffice = true;
    const auto explained = read_map(folder / "m.png", hints);
    REQUIRE(explained);
    CHECK(explained->depth.empty());
    CHECK(explained->cone_planes == map.cone_planes);

    hints = {};
    hints.relief = folder / "relief.png";
    const auto refuses = [&](const ReliefMap& relief, const char* words) {
        REQUIRE(write_map(hints.relief, relief));
        const auto read = read_map(folder / "m.png", hints);
        CAPTURE(words);
        REQUIRE_FALSE(read);
        CHECK(read.error().code == ErrorCode::bad_data);
        CHECK(read.error().message.find(words) != std::string::npos);
    };
    ReliefMap other = relief_of(map);
    other.grid.wrap_x = Wrap::clamp;
    refuses(other, "wrap");
    other = relief_of(map);
    other.grid.pixel_aspect = 1;
    refuses(other, "pixel aspect");
    other = relief_of(map);
    other.info.source_hash = "ff00";
    refuses(other, "other heights");
    refuses(relief_of(some_map("acm", 4, ChannelLayout::rgba, BitDepth::unorm8)), "bits");
    other = relief_of(map);
    other.grid.width = 2;
    for (Image<float>* plane : {&other.normal_x, &other.normal_y, &other.cone, &other.depth}) *plane = Image<float>(2, height);
    refuses(other, "texels");
    refuses(some_map("acm", 4, ChannelLayout::rgba, BitDepth::unorm16), "found acm");

    // A map that needs none does not ignore the flag.
    REQUIRE(write_map(hints.relief, relief_of(map)));
    CHECK(read_map(folder / "m.png", hints));
    CHECK(read_map(hints.relief, hints).error().code == ErrorCode::usage);
}

TEST_CASE("half a pair is no map") {
    TemporaryFolder folder;
    ReliefMap map = some_map("acm", 8, ChannelLayout::pair, BitDepth::unorm16);
    map.info.argument_hash = "1";
    REQUIRE(write_map(folder / "m.png", map));
    REQUIRE(write_map(folder / "relief.png", relief_of(map)));
    map.info.argument_hash = "2";
    REQUIRE(write_map(folder / "n.png", map));
    MapHints hints;
    hints.relief = folder / "relief.png";
    CHECK(read_map(folder / "m.png", hints));
    std::filesystem::rename(folder / "n_b.png", folder / "m_b.png");
    CHECK(read_map(folder / "m.png", hints).error().message.find("m_b.png") != std::string::npos);
    std::filesystem::remove(folder / "m_b.png");
    CHECK(read_map(folder / "m.png", hints).error().code == ErrorCode::no_input);
}

TEST_CASE("layouts refuse what they cannot hold") {
    const auto refused = [](const char* name, const char* kind, int planes, ChannelLayout layout, BitDepth bits) {
        const ReliefMap map = some_map(kind, planes, layout, bits);
        const Result<void> result = check_map_format(name, map.info);
        return !result && result.error().code == ErrorCode::usage;
    };
    for (const Case& c : cases) CHECK_FALSE(refused(c.name, c.kind, c.planes, c.layout, c.bits));
    CHECK(refused("a.png", "acm", 8, ChannelLayout::rgba, BitDepth::unorm8));
    CHECK(refused("a.png", "acm", 4, ChannelLayout::pair, BitDepth::unorm8));
    CHECK(refused("a.png", "acm", 6, ChannelLayout::rgba, BitDepth::unorm8));
    CHECK(refused("a.png", "cone-stack", 5, ChannelLayout::rgba, BitDepth::unorm8));
    CHECK(refused("a.png", "cone-stack", 8, ChannelLayout::side, BitDepth::unorm8));
    CHECK(refused("a.png", "cone", 0, ChannelLayout::pair, BitDepth::unorm8));
    CHECK(refused("a.png", "acm", 8, ChannelLayout::named, BitDepth::unorm8));
}

TEST_CASE("a kind of a later version is told, not guessed at") {
    TemporaryFolder folder;
    ReliefMap map = relief_of(some_map("acm", 4, ChannelLayout::rgba, BitDepth::unorm16));
    map.info.kind = "quadric-9";
    REQUIRE(write_map(folder / "m.png", map));
    const auto read = read_map(folder / "m.png");
    REQUIRE_FALSE(read);
    CHECK(read.error().message.find("quadric-9") != std::string::npos);
    MapHints hints;
    hints.cones_suffice = true;
    REQUIRE(read_map(folder / "m.png", hints));
    CHECK(read_map(folder / "m.png", hints)->info.kind == "quadric-9");
    hints = {};
    hints.channel_order = "RGBA";
    CHECK(read_map(folder / "m.png", hints)->depth == map.depth);
}

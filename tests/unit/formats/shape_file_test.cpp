#include "formats/map_kind.h"
#include "formats/shape_file.h"

#include "formats/map_file.h"

#include "temporary_folder.h"

#include <catch2/catch.hpp>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

/// A disc that touches the border, 37 x 23.
ShapeMap disc(BitDepth bits, bool signed_distance) {
    Image<float> samples(37, 23, 1);
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 37; ++x)
            if ((x - 5) * (x - 5) + (y - 9) * (y - 9) < 40) samples(x, y) = 0;
    ShapeOptions options;
    options.wrap_x = true;
    const Result<BinaryShape> shape = make_shape(samples, options, "disc");
    REQUIRE(shape);
    ShapeMapOptions bake;
    bake.bits = bits;
    bake.signed_distance = signed_distance;
    bake.scale_f = 0.75;
    Result<ShapeMap> map = bake_shape_map(*shape, bake);
    REQUIRE(map);
    map->info.inverted = true;
    map->info.version = "1.2.3";
    map->info.source_hash = "0123";
    map->info.argument_hash = "4567";
    return *map;
}

void check_same(const ShapeMap& read, const ShapeMap& written) {
    CHECK(read.grid == written.grid);
    CHECK(to_json(read.info, read.grid) == to_json(written.info, written.grid));
    CHECK(read.gradient_x == written.gradient_x);
    CHECK(read.gradient_y == written.gradient_y);
    CHECK(read.distance == written.distance);
    CHECK(read.shape == written.shape);
}

} // namespace

TEST_CASE("A shape map comes back as it was written") {
    const TemporaryFolder folder;
    const std::pair<const char*, BitDepth> files[] = {{"a.png", BitDepth::unorm8},  {"a.png", BitDepth::unorm16}, {"a.tif", BitDepth::unorm8},
                                                      {"a.tif", BitDepth::unorm16}, {"a.tif", BitDepth::half},    {"a.tif", BitDepth::float32},
                                                      {"a.exr", BitDepth::half},    {"a.exr", BitDepth::float32}};
    for (const auto& [name, bits] : files)
        for (const bool signed_distance : {false, true}) {
            INFO(name << " " << int(bits) << signed_distance);
            ShapeMap map = disc(bits, signed_distance);
            map.info.named = std::string(name) == "a.exr" && signed_distance;
            REQUIRE(write_shape_map(folder / name, map));
            CHECK(kind_of_map(folder / name) == std::string("shape"));
            const Result<ShapeMap> read = read_shape_map(folder / name);
            REQUIRE(read);
            check_same(*read, map);
        }
}

TEST_CASE("Formats that cannot hold a shape map refuse it, and those without metadata are not read") {
    const TemporaryFolder folder;
    CHECK(write_shape_map(folder / "a.png", disc(BitDepth::half, false)).error().code == ErrorCode::usage);
    CHECK(write_shape_map(folder / "a.exr", disc(BitDepth::unorm8, false)).error().code == ErrorCode::usage);
    CHECK(write_shape_map(folder / "a.jpg", disc(BitDepth::unorm8, false)).error().code == ErrorCode::usage);
    CHECK(folder.entries() == 0);
    REQUIRE(write_shape_map(folder / "a.tga", disc(BitDepth::unorm8, false)));
    CHECK(read_shape_map(folder / "a.tga").error().code == ErrorCode::bad_data);
    CHECK(write_shape_map(folder / "a.dds", disc(BitDepth::half, false)));
    CHECK(write_shape_map(folder / "a.ktx2", disc(BitDepth::unorm16, false)));
}

TEST_CASE("A shape map is no cone map") {
    const TemporaryFolder folder;
    REQUIRE(write_shape_map(folder / "a.png", disc(BitDepth::unorm8, false)));
    const Result<ReliefMap> cones = read_map(folder / "a.png");
    REQUIRE(!cones);
    CHECK(cones.error().code == ErrorCode::bad_data);
}

TEST_CASE("Damaged facts of a shape map are named") {
    const TemporaryFolder folder;
    ShapeMap map = disc(BitDepth::float32, false);
    map.info.tau = -1;
    REQUIRE(write_shape_map(folder / "a.exr", map));
    const Result<ShapeMap> read = read_shape_map(folder / "a.exr");
    REQUIRE(!read);
    CHECK(read.error().code == ErrorCode::bad_data);
    CHECK(read.error().message.find("tau") != std::string::npos);
    map = disc(BitDepth::float32, false);
    map.distance(3, 3) = 1.5f;
    REQUIRE(write_shape_map(folder / "a.exr", map));
    CHECK(read_shape_map(folder / "a.exr").error().code == ErrorCode::bad_data);
}

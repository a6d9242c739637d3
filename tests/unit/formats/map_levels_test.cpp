// Mip chains as files: every level comes back bit for bit.

#include "formats/map_file.h"

#include "mip_maps.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

void check_level(const ReliefMap& back, const ReliefMap& map) {
    CHECK(back.normal_x == map.normal_x);
    CHECK(back.normal_y == map.normal_y);
    CHECK(back.cone == map.cone);
    CHECK(back.depth == map.depth);
    CHECK(back.cone_planes == map.cone_planes);
    CHECK(back.grid.width == map.grid.width);
    CHECK(back.grid.height == map.grid.height);
    CHECK(back.grid.pixel_aspect == Approx(map.grid.pixel_aspect));
}

} // namespace

TEST_CASE("EXR and TIFF return every mip level of every depth, and refuse one beyond the last") {
    TemporaryFolder folder;
    const std::pair<const char*, BitDepth> files[] = {
        {"8.tif", BitDepth::unorm8},   {"16.tif", BitDepth::unorm16}, {"h.tif", BitDepth::half},
        {"f.tif", BitDepth::float32},  {"h.exr", BitDepth::half},     {"f.exr", BitDepth::float32},
    };
    for (const auto& [name, bits] : files)
        for (const auto& [width, height] : {std::pair{256, 128}, {151, 77}, {5, 1}, {1, 1}}) {
            CAPTURE(name, width, height);
            const std::vector<ReliefMap> chain = mip_chain(width, height, bits);
            const Result<void> written = write_map_levels(folder / name, chain);
            if (!written) FAIL(written.error().message);
            for (std::size_t n = 0; n < chain.size(); ++n) {
                CAPTURE(n);
                MapHints hints;
                hints.level = int(n);
                const Result<ReliefMap> back = read_map(folder / name, hints);
                if (!back) FAIL(back.error().message);
                check_level(*back, chain[n]);
                CHECK(back->info.levels == int(chain.size()));
            }
            MapHints beyond;
            beyond.level = int(chain.size());
            const Result<ReliefMap> refused = read_map(folder / name, beyond);
            REQUIRE_FALSE(refused);
            CHECK(refused.error().code == ErrorCode::bad_data);
            CHECK(refused.error().message.find("mip level") != std::string::npos);
        }
}

TEST_CASE("named channels have levels too, and threads change no byte") {
    TemporaryFolder folder;
    ReliefMapInfo info;
    info.kind = "acm";
    info.planes = 8;
    info.layout = ChannelLayout::named;
    std::vector<ReliefMap> chain = mip_chain(300, 200, BitDepth::half, info);
    for (ReliefMap& level : chain) level.cone = {};
    REQUIRE(write_map_levels(folder / "a.exr", chain, 1));
    REQUIRE(write_map_levels(folder / "b.exr", chain, 4));
    CHECK(file_bytes(folder / "a.exr") == file_bytes(folder / "b.exr"));
    MapHints hints;
    hints.level = 2;
    const Result<ReliefMap> back = read_map(folder / "a.exr", hints);
    if (!back) FAIL(back.error().message);
    check_level(*back, chain[2]);
}

TEST_CASE("PNG and TGA chains are numbered files, each a map of its own") {
    TemporaryFolder folder;
    const std::vector<ReliefMap> chain = mip_chain(12, 6, BitDepth::unorm8);
    REQUIRE(write_map_levels(folder / "m.png", chain));
    REQUIRE(write_map_levels(folder / "m.tga", chain));
    CHECK(folder.entries() == 8);
    for (std::size_t n = 0; n < chain.size(); ++n) {
        const Result<ReliefMap> back = read_map(folder / (n ? "m_mip" + std::to_string(n) + ".png" : "m.png"));
        REQUIRE(back);
        check_level(*back, chain[n]);
    }
    MapHints hints;
    hints.level = 1;
    CHECK(read_map(folder / "m.png", hints).error().code == ErrorCode::usage);
}

TEST_CASE("a chain cut short is refused at the level that is cut") {
    TemporaryFolder folder;
    const std::vector<ReliefMap> chain = mip_chain(128, 128, BitDepth::unorm16);
    REQUIRE(write_map_levels(folder / "m.tif", chain));
    const std::string whole = file_bytes(folder / "m.tif");
    int refused = 0;
    for (std::size_t keep = whole.size() / 2; keep < whole.size(); keep += whole.size() / 16) {
        write_bytes(folder / "m.tif", whole.substr(0, keep));
        for (std::size_t n = 0; n < chain.size(); ++n) {
            MapHints hints;
            hints.level = int(n);
            const Result<ReliefMap> back = read_map(folder / "m.tif", hints);
            if (back) CHECK(back->depth == chain[n].depth);
            else ++refused;
        }
    }
    CHECK(refused > 0);
}

TEST_CASE("halves side by side have no levels") {
    ReliefMapInfo info;
    info.kind = "acm";
    info.planes = 8;
    info.layout = ChannelLayout::side;
    CHECK(write_map_levels("/nowhere/a.tif", mip_chain(8, 8, BitDepth::unorm8, info)).error().code == ErrorCode::usage);
}

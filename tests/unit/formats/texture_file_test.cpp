// DDS and KTX2 byte by byte, against their specifications.

#include "formats/map_file.h"
#include "formats/map_pixels.h"

#include "mip_maps.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cstring>

using namespace reliefbake;
using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {

constexpr BitDepth depths[] = {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32};

/// Reads little-endian numbers at offsets.
struct Bytes {
    std::string data;
    template <class T = std::uint32_t>
    T at(std::size_t offset) const {
        T value{};
        REQUIRE(offset + sizeof value <= data.size());
        std::memcpy(&value, data.data() + offset, sizeof value);
        return value;
    }
};

/// The samples of a level as they must lie in the file.
std::string samples(const ReliefMap& map) {
    const LayoutImage image = layout_images(map.info)[0];
    std::string bytes(interleaved_bytes(map, image, map.info.bits), '\0');
    interleave(map, image, map.info.bits, reinterpret_cast<std::byte*>(bytes.data()));
    return bytes;
}

} // namespace

TEST_CASE("samples are codes, halves and floats, R G B A, top row first") {
    const ReliefMap map = mip_chain(3, 2, BitDepth::unorm8)[0];
    const std::string bytes = samples(map);
    REQUIRE(bytes.size() == 24);
    CHECK(std::uint8_t(bytes[4]) == std::lround(map.normal_x(1, 0) * 255));
    CHECK(std::uint8_t(bytes[3 * 4 + 3]) == std::lround(map.depth(0, 1) * 255));
    ReliefMap half = mip_chain(1, 1, BitDepth::half)[0];
    half.normal_x[0] = -0.5f; // 0xb800
    half.depth[0] = 1;        // 0x3c00
    const std::string two = samples(half);
    CHECK(two.substr(0, 2) == std::string("\x00\xb8", 2));
    CHECK(two.substr(6, 2) == std::string("\x00\x3c", 2));
}

TEST_CASE("DDS: header, masks or DX10 header, levels from the largest") {
    TemporaryFolder folder;
    const std::uint32_t formats[] = {0, 11, 10, 2}; // DXGI_FORMAT
    for (const BitDepth bits : depths)
        for (const bool mips : {false, true}) {
            CAPTURE(int(bits), mips);
            const std::vector<ReliefMap> chain = mip_chain(10, 6, bits);
            REQUIRE((mips ? write_map_levels(folder / "m.dds", chain) : write_map(folder / "m.dds", chain[0])));
            const Bytes file{file_bytes(folder / "m.dds")};
            CHECK(file.data.substr(0, 4) == "DDS ");
            CHECK(file.at(4) == 124);
            CHECK((file.at(8) & 0x1007) == 0x1007);
            CHECK(bool(file.at(8) & 0x20000) == mips);
            CHECK(file.at(12) == 6);
            CHECK(file.at(16) == 10);
            CHECK(file.at(20) == 10u * 4 * std::uint32_t(sample_bytes_of(bits)));
            CHECK(file.at(28) == (mips ? 4u : 1u));
            CHECK(file.at(76) == 32);
            CHECK(bool(file.at(108) & 0x400008) == mips);
            const bool masks = bits == BitDepth::unorm8;
            if (masks) {
                CHECK(file.at(80) == 0x41);
                CHECK(file.at(88) == 32);
                CHECK(file.at(92) == 0xff);
                CHECK(file.at(104) == 0xff000000);
            } else {
                CHECK(file.at(80) == 4);
                CHECK(file.data.substr(84, 4) == "DX10");
                CHECK(file.at(128) == formats[int(bits)]);
                CHECK(file.at(132) == 3);
                CHECK(file.at(140) == 1);
            }
            std::string pixels;
            for (std::size_t n = 0; n < (mips ? chain.size() : 1); ++n) pixels += samples(chain[n]);
            CHECK((file.data.substr(masks ? 128 : 148) == pixels));
        }
    const auto read = read_map(folder / "m.dds");
    CHECK(read.error().code == ErrorCode::bad_data);
    CHECK(read.error().message.find("png, tif, exr") != std::string::npos);
}

TEST_CASE("KTX2: header, index, descriptor, metadata, levels from the smallest at aligned places") {
    TemporaryFolder folder;
    const std::uint32_t formats[] = {37, 91, 97, 109}, type_sizes[] = {1, 2, 2, 4};
    for (const BitDepth bits : depths) {
        CAPTURE(int(bits));
        const std::vector<ReliefMap> chain = mip_chain(5, 3, bits);
        REQUIRE(write_map_levels(folder / "m.ktx2", chain));
        const Bytes file{file_bytes(folder / "m.ktx2")};
        CHECK((file.data.substr(0, 12) == std::string("\xabKTX 20\xbb\r\n\x1a\n", 12)));
        const std::uint32_t texel = 4 * type_sizes[int(bits)];
        const std::uint32_t header[] = {formats[int(bits)], type_sizes[int(bits)], 5, 3, 0, 0, 1, 3, 0};
        for (std::size_t i = 0; i < 9; ++i) CHECK(file.at(12 + 4 * i) == header[i]);

        // Descriptor: one block, 4 samples.
        const std::uint32_t dfd = file.at(48);
        CHECK(dfd == 80 + 3 * 24);
        CHECK(file.at(52) == 92);
        CHECK(file.at(dfd) == 92);
        CHECK(file.at(dfd + 8) == (88u << 16 | 2));
        CHECK(file.at(dfd + 12) == (1u << 16 | 1)); // linear, no primaries, RGBSDA
        CHECK(file.at<std::uint8_t>(dfd + 20) == texel);
        CHECK(file.at<std::uint8_t>(dfd + 28 + 3 * 16 + 3) == (is_unorm(bits) ? 15 : 0xc0 | 15));
        CHECK(file.at(dfd + 28 + 12) == (bits == BitDepth::unorm8 ? 255u : bits == BitDepth::unorm16 ? 65535u : 0x3f800000u));

        // Keys: in order, each padded to 4.
        const std::uint32_t keys = file.at(56), keys_length = file.at(60);
        CHECK(keys == dfd + 92);
        CHECK(file.data.substr(keys + 4, 10) == std::string("KTXwriter\0", 10));
        const std::uint32_t second = keys + 4 + (file.at(keys) + 3) / 4 * 4;
        CHECK(file.data.substr(second + 4, 11) == std::string("reliefbake\0", 11));
        const auto facts = nlohmann::json::parse(file.data.substr(second + 15, file.at(second) - 12));
        CHECK(facts["kind"] == "cone");
        CHECK(facts["levels"] == 3);
        CHECK(second + 4 + (file.at(second) + 3) / 4 * 4 == keys + keys_length);

        // Levels.
        std::uint64_t end = keys + keys_length;
        for (std::size_t n = chain.size(); n-- > 0;) {
            const auto offset = file.at<std::uint64_t>(80 + 24 * n), length = file.at<std::uint64_t>(88 + 24 * n);
            CHECK(offset % texel == 0);
            CHECK((offset >= end && offset < end + texel));
            CHECK(file.at<std::uint64_t>(96 + 24 * n) == length);
            CHECK((file.data.substr(offset, length) == samples(chain[n])));
            end = offset + length;
        }
        CHECK(end == file.data.size());
    }
    CHECK(read_map(folder / "m.ktx2").error().code == ErrorCode::bad_data);
}

TEST_CASE("DDS and KTX2 of one and two channels name their formats; three are refused") {
    TemporaryFolder folder;
    const std::uint32_t dxgi[][2] = {{61, 49}, {56, 35}, {54, 34}, {41, 16}}, vk[][2] = {{9, 16}, {70, 77}, {76, 83}, {100, 103}};
    for (const BitDepth bits : depths)
        for (const bool cones : {false, true}) {
            ReliefMap map = mip_chain(3, 3, bits)[0];
            map.info.held = {false, cones};
            map.normal_x = {}, map.normal_y = {};
            if (!cones) map.cone = {};
            const std::size_t texel = std::size_t(1 + cones) * std::size_t(sample_bytes_of(bits)), data = 9 * texel;
            const fs::path dds = folder / "m.dds", ktx = folder / "m.ktx2";
            REQUIRE(write_map(dds, map));
            const Bytes a{file_bytes(dds)};
            CHECK(a.at(128) == dxgi[int(bits)][cones]);
            CHECK(a.at(20) == 3 * texel);
            CHECK(a.data.size() == 148 + data);
            REQUIRE(write_map(ktx, map));
            const Bytes b{file_bytes(ktx)};
            CHECK(b.at(12) == vk[int(bits)][cones]);
            const auto offset = std::size_t(b.at<std::uint64_t>(80));
            CHECK(offset % 4 == 0);
            CHECK(offset + data == b.data.size());
            CHECK(b.at<std::uint16_t>(b.at(48) + 4 + 6) == 24 + 16 * (1 + cones)); // the descriptor's block
            // Depth comes last in each texel.
            if (bits == BitDepth::unorm8) CHECK(std::uint8_t(b.data[offset + texel - 1]) == std::lround(map.depth[0] * 255));
            map.info.held = {true, false}, map.normal_x = map.normal_y = Image<float>(3, 3);
            CHECK_FALSE(write_map(dds, map));
            CHECK_FALSE(write_map(ktx, map));
        }
}

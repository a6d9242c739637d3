#include "formats/read_image.h"
#include "formats/write_image.h"

#include "png_oracle.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <cstring>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

std::vector<float> pixels(const std::filesystem::path& path, const std::string& channel = "") {
    const Result<SourceImage> image = read_image(path, {channel, 0});
    INFO((image ? "" : image.error().message));
    REQUIRE(image);
    return {image->plane.begin(), image->plane.end()};
}

template <class T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A little-endian TIFF of one strip and one channel; sample_format 1: unsigned, 2: signed, 3: floating.
std::string tiff(int bits, int sample_format, int width, int height, const std::string& data) {
    std::string bytes("II*\0", 4);
    append(bytes, std::uint32_t(8 + data.size()));
    bytes += data;
    const std::uint32_t tags[][2] = {{256, std::uint32_t(width)}, {257, std::uint32_t(height)}, {258, std::uint32_t(bits)},
                                     {259, 1}, {262, 1}, {273, 8}, {277, 1}, {278, std::uint32_t(height)},
                                     {279, std::uint32_t(data.size())}, {339, std::uint32_t(sample_format)}};
    append(bytes, std::uint16_t(std::size(tags)));
    for (const auto& [tag, value] : tags) {
        append(bytes, std::uint16_t(tag));
        append(bytes, std::uint16_t(4)); // LONG
        append(bytes, std::uint32_t(1));
        append(bytes, value);
    }
    append(bytes, std::uint32_t(0));
    return bytes;
}

template <class T>
std::string raw(std::initializer_list<T> values) {
    std::string bytes;
    for (const T value : values) append(bytes, value);
    return bytes;
}

} // namespace

TEST_CASE("integers are value / largest value, correctly rounded, at every sample width") {
    TemporaryFolder folder;
    const auto check = [&](const std::string& file, const std::vector<float>& expected, int bit_depth, bool is_integer) {
        write_bytes(folder / "t.tif", file);
        const Result<SourceImage> image = read_image(folder / "t.tif", {});
        REQUIRE(image);
        CHECK(std::vector<float>(image->plane.begin(), image->plane.end()) == expected);
        CHECK(image->bit_depth == bit_depth);
        CHECK(image->is_integer == is_integer);
        CHECK(image->format == "tiff");
    };
    check(tiff(1, 1, 8, 1, "\xa5"), {1, 0, 1, 0, 0, 1, 0, 1}, 1, true);
    check(tiff(4, 1, 4, 1, std::string("\x01\x7f", 2)), {0, 1 / 15.0f, 7 / 15.0f, 1}, 4, true);
    check(tiff(12, 1, 4, 1, std::string("\x00\x00\x01\x7f\xff\xff", 6)), {0, 1 / 4095.0f, 2047 / 4095.0f, 1}, 12, true);
    check(tiff(16, 1, 3, 1, raw<std::uint16_t>({1, 4660, 65535})), {1 / 65535.0f, 4660 / 65535.0f, 1}, 16, true);
    check(tiff(16, 2, 2, 1, raw<std::int16_t>({-1, 32767})), {-1 / 32767.0f, 1}, 16, true);
    check(tiff(32, 1, 2, 1, raw<std::uint32_t>({1, 0xffffffff})), {float(1 / 4294967295.0), 1}, 32, true);
    check(tiff(32, 3, 2, 1, raw<float>({-3.5f, 1e30f})), {-3.5f, 1e30f}, 32, false);
    check(tiff(64, 3, 2, 2, raw<double>({-3.5, 0.1, 7, 1e-3})), {-3.5f, 0.1f, 7, 1e-3f}, 64, false);
}

TEST_CASE("a single row of doubles, which OpenImageIO answers with zeros, is refused") {
    TemporaryFolder folder;
    write_bytes(folder / "t.tif", tiff(64, 3, 2, 1, raw<double>({1, 2})));
    CHECK(read_image(folder / "t.tif", {}).error().code == ErrorCode::bad_data);
}

TEST_CASE("a TIFF without all of its pixels is refused, a no-data value is found") {
    TemporaryFolder folder;
    const std::string whole = tiff(32, 3, 2, 2, raw<float>({1, 2, 3, 4}));
    std::string lying = whole;
    const std::size_t strip_bytes = lying.find(std::string("\x17\x01\x04\0", 4)); // tag 279, LONG
    REQUIRE(strip_bytes != std::string::npos);
    lying[strip_bytes + 9] = 1; // 16 bytes become 272, more than the file has
    write_bytes(folder / "cut.tif", lying);
    CHECK(read_image(folder / "cut.tif", {}).error().message.find("truncated") != std::string::npos);

    // Tag 42113, ASCII, 4 bytes, in place of SampleFormat's neighbour: one more entry at the directory's end.
    std::string with_no_data = whole;
    const std::size_t directory = 8 + 16;
    with_no_data[directory] = 11;
    with_no_data.insert(with_no_data.size() - 4, std::string("\x81\xa4\x02\0\x04\0\0\0-99\0", 12));
    write_bytes(folder / "nodata.tif", with_no_data);
    const Result<SourceImage> image = read_image(folder / "nodata.tif", {});
    REQUIRE(image);
    CHECK(image->no_data == -99.0f);
    write_bytes(folder / "whole.tif", whole);
    CHECK_FALSE(read_image(folder / "whole.tif", {})->no_data);
}

TEST_CASE("Netpbm files: maximum value, byte order, row order") {
    TemporaryFolder folder;
    write_bytes(folder / "a.pgm", "P2\n3 1\n255\n0 51 255\n");
    CHECK(pixels(folder / "a.pgm") == std::vector<float>{0, 0.2f, 1});
    // OpenImageIO truncates while it rescales 16-bit codes: the upper half comes out one code too low (docs/FORMATS.md).
    write_bytes(folder / "b.pgm", std::string("P5\n2 1\n65535\n\x12\x34\xff\xff", 17));
    const std::vector<float> codes = pixels(folder / "b.pgm");
    CHECK(codes[0] == 4660 / 65535.0f);
    CHECK(std::abs(codes[1] - 1) <= 1.01f / 65535);
    // PFM stores the bottom row first; a positive scale means big-endian.
    write_bytes(folder / "c.pfm", "Pf\n1 2\n-1.0\n" + raw<float>({1.5f, -2}));
    CHECK(pixels(folder / "c.pfm") == std::vector<float>{-2, 1.5f});
}

TEST_CASE("channels are chosen by name, grey pixels keep their value") {
    TemporaryFolder folder;
    const std::vector<std::uint8_t> rgba{10, 20, 30, 0, 77, 77, 77, 255};
    REQUIRE(write_png(folder / "c.png", 2, 1, 4, rgba));
    CHECK(pixels(folder / "c.png", "R") == std::vector<float>{10 / 255.0f, 77 / 255.0f});
    CHECK(pixels(folder / "c.png", "A") == std::vector<float>{0, 1});
    const float r = 10 / 255.0f, g = 20 / 255.0f, b = 30 / 255.0f;
    const std::vector<float> luminance{float(0.2126 * r + 0.7152 * g + 0.0722 * b), 77 / 255.0f};
    CHECK(pixels(folder / "c.png") == luminance);
    CHECK(pixels(folder / "c.png", "Y") == luminance);

    const Result<SourceImage> none = read_image(folder / "c.png", {"relief.depth", 0});
    CHECK(none.error().code == ErrorCode::bad_data);
    CHECK(none.error().message.find("R, G, B, A") != std::string::npos);

    REQUIRE(write_png(folder / "g.png", 2, 1, 1, std::vector<std::uint8_t>{1, 2}));
    CHECK(pixels(folder / "g.png", "R") == pixels(folder / "g.png"));
}

TEST_CASE("the pixel hash is of size and pixels, not of the file") {
    TemporaryFolder folder;
    const std::vector<std::uint8_t> samples{1, 2, 3, 4, 5, 6};
    REQUIRE(write_png(folder / "a.png", 3, 2, 1, samples));
    REQUIRE(write_png(folder / "b.png", 2, 3, 1, samples));
    write_bytes(folder / "c.pgm", std::string("P5\n3 2\n255\n") + "\1\2\3\4\5\6");
    const auto hash = [&](const char* name) { return read_image(folder / name, {})->pixel_hash; };
    CHECK(hash("a.png").size() == 32);
    CHECK(hash("a.png") == hash("c.pgm"));
    CHECK(hash("a.png") != hash("b.png"));
}

TEST_CASE("what cannot be opened is told apart from what cannot be decoded") {
    TemporaryFolder folder;
    CHECK(read_image(folder / "none.png", {}).error().code == ErrorCode::no_input);
    CHECK(read_image(folder.path(), {}).error().code == ErrorCode::no_input);
    write_bytes(folder / "empty.png", "");
    CHECK(read_image(folder / "empty.png", {}).error().code == ErrorCode::bad_data);
    write_bytes(folder / "text.png", "not an image");
    CHECK(read_image(folder / "text.png", {}).error().code == ErrorCode::bad_data);
}

TEST_CASE("a tiny budget refuses, a larger one reads") {
    TemporaryFolder folder;
    REQUIRE(write_png(folder / "a.png", 100, 100, 1, std::vector<std::uint8_t>(10'000)));
    CHECK(read_image(folder / "a.png", {"", 9'000}).error().message.find("--max-bytes") != std::string::npos);
    CHECK(read_image(folder / "a.png", {"", 40'000}));
}

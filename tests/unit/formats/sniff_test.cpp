#include "formats/sniff.h"

#include <catch2/catch.hpp>

#include <string>

using namespace reliefbake;

namespace {
std::optional<ImageFormat> sniff(const std::string& head, const char* name = "x.bin") {
    return sniff_format(std::as_bytes(std::span(head)), name);
}
} // namespace

TEST_CASE("a reader is chosen by content, not by name") {
    CHECK(sniff("\x89PNG\r\n\x1a\n....", "x.exr") == ImageFormat::png);
    CHECK(sniff(std::string("II*\0", 4)) == ImageFormat::tiff);
    CHECK(sniff(std::string("MM\0+", 4)) == ImageFormat::tiff);
    CHECK(sniff("v/1\x01") == ImageFormat::openexr);
    CHECK(sniff("#?RADIANCE\n") == ImageFormat::hdr);
    CHECK(sniff("\xff\xd8\xff\xe0") == ImageFormat::jpeg);
    CHECK(sniff("BM....") == ImageFormat::bmp);
    CHECK(sniff("P5\n") == ImageFormat::pnm);
    CHECK(sniff("Pf\n") == ImageFormat::pnm);
    CHECK_FALSE(sniff("8BPS", "x.psd"));
    CHECK_FALSE(sniff("", "x.png"));
    CHECK_FALSE(sniff("\x89PNG", "x.png"));
}

TEST_CASE("TGA has no magic number: its name and its fixed fields decide") {
    std::string head(18, '\0');
    head[2] = 2;
    head[16] = 32;
    CHECK(sniff(head, "x.TGA") == ImageFormat::targa);
    CHECK_FALSE(sniff(head, "x.png"));
    head[16] = 31;
    CHECK_FALSE(sniff(head, "x.tga"));
    CHECK(sniff("\x89PNG\r\n\x1a\n..........", "x.tga") == ImageFormat::png);
}

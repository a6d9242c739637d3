#include "formats/image_header.h"

#include "formats/decode_session.h"
#include "formats/file_identity.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <random>

using namespace reliefbake;
using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {

/// The bundled images, and those of the large set that are there.
std::vector<fs::path> images() {
    std::vector<fs::path> files;
    const char* set = std::getenv("RELIEFBAKE_DATA");
    const fs::path large = set ? fs::path(set) : fs::path(RELIEFBAKE_TEST_DATA) / "../../../shared/data";
    for (const fs::path& root : {fs::path(RELIEFBAKE_TEST_DATA), large})
        for (const char* folder : {"heights", "shapes"})
            if (std::error_code none; fs::is_directory(root / folder, none))
                for (const auto& entry : fs::directory_iterator(root / folder))
                    if (entry.is_regular_file() && entry.path().extension() != ".md") files.push_back(entry.path());
    return files;
}

} // namespace

TEST_CASE("What a header claims is what the decoder finds") {
    int looked_at = 0;
    for (const fs::path& file : images()) {
        const Result<DecodeSession> session = DecodeSession::open(file, 0, 0);
        if (!session) continue;
        CAPTURE(file.string());
        const std::optional<ImageHeader> header = peek_image_header(file);
        REQUIRE(header);
        ++looked_at;
        CHECK(header->width == session->claims().width);
        CHECK(header->height == session->claims().height);
        // Palettes and single bits are decoded to 8.
        const bool as_stored = session->claims().sample < SampleType::half && session->format() != ImageFormat::bmp && header->bits >= 8;
        if (as_stored) CHECK(header->bits == session->claims().bit_depth);
    }
    CHECK(looked_at >= 8);
}

TEST_CASE("Headers that are cut or damaged claim nothing, or something, and never crash") {
    TemporaryFolder folder;
    std::mt19937 random(1);
    for (const fs::path& file : images()) {
        const std::string whole = file_bytes(file).substr(0, 4096);
        const fs::path cut = folder / ("cut" + file.extension().string());
        for (std::size_t size = 0; size < std::min<std::size_t>(whole.size(), 400); size += 7) {
            write_bytes(cut, whole.substr(0, size));
            (void)peek_image_header(cut);
        }
        for (int round = 0; round < 100; ++round) {
            std::string damaged = whole;
            for (int k = 0; k < 4; ++k) damaged[random() % std::min<std::size_t>(whole.size(), 200)] = char(random());
            write_bytes(cut, damaged);
            if (const auto header = peek_image_header(cut)) {
                CHECK(header->width > 0);
                CHECK(header->height > 0);
                CHECK(header->width <= 0x7fffffff);
                CHECK(header->height <= 0x7fffffff);
            }
        }
    }
    CHECK_FALSE(peek_image_header(folder / "none.png"));
    CHECK_FALSE(peek_image_header(folder.path()));
}

TEST_CASE("Hashes of images tell what is decoded, and stamps tell every write") {
    TemporaryFolder folder;
    const std::string pixels = "\x01\x02\x03\x04";
    write_bytes(folder / "a.pgm", "P5\n2 2\n255\n" + pixels);
    write_bytes(folder / "b.pgm", "P5\n# x\n2 2\n255\n" + pixels);
    write_bytes(folder / "c.pgm", "P5\n4 1\n255\n" + pixels);
    write_bytes(folder / "d.pgm", "P5\n2 2\n255\n\x01\x02\x03\x05");
    const auto image = [&](const char* name) { return *hash_of_image(folder / name, 0); };
    CHECK(image("a.pgm") == image("b.pgm"));
    CHECK(image("a.pgm") != image("c.pgm"));
    CHECK(image("a.pgm") != image("d.pgm"));
    CHECK(*hash_of_bytes(folder / "a.pgm") != *hash_of_bytes(folder / "b.pgm"));
    CHECK(*hash_of_bytes(folder / "a.pgm") == hash_of_text("P5\n2 2\n255\n" + pixels));
    CHECK(hash_of_image(folder / "none.pgm", 0).error().code == ErrorCode::no_input);
    write_bytes(folder / "bad.pgm", "P5\n200 200\n255\n" + pixels);
    CHECK(hash_of_image(folder / "bad.pgm", 0).error().code == ErrorCode::bad_data);

    const FileStamp before = *stamp_of(folder / "a.pgm");
    CHECK(*stamp_of(folder / "a.pgm") == before);
    fs::last_write_time(folder / "a.pgm", fs::file_time_type::clock::now() + std::chrono::seconds(5));
    CHECK_FALSE(*stamp_of(folder / "a.pgm") == before);
    CHECK_FALSE(stamp_of(folder / "none"));
    CHECK_FALSE(stamp_of(folder.path()));
}

// Each hostile image is decoded or refused with one clear line, within 2 s and 512 MB, and the caller lives on; the ones
// named edge_ are unusual but valid and must decode.

#include "formats/image_worker.h"
#include "formats/read_image.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using namespace reliefbake;
namespace fs = std::filesystem;

namespace {

/// The large set of real and hostile files, when this machine has it.
fs::path shared_data() {
    const char* given = std::getenv("RELIEFBAKE_DATA");
    return given ? given : RELIEFBAKE_SHARED_DATA;
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Largest resident set of the worker so far, in MiB; 0 when it has died.
long worker_peak_mib() {
    std::ifstream status("/proc/" + std::to_string(ImageWorker::instance().pid()) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::atol(line.c_str() + 6) / 1024;
    return 0;
}

void check_refusal(const Error& error, const fs::path& path) {
    CHECK(error.code == ErrorCode::bad_data);
    CHECK(error.message.starts_with(path.string() + ": "));
    CHECK(error.message.find('\n') == std::string::npos);
    CHECK(error.message.size() < path.string().size() + 500);
    CHECK(error.message.find("/proc/") == std::string::npos);
}

void check_folder(const fs::path& folder) {
    for (const fs::path& path : files_in(folder)) {
        CAPTURE(path.filename());
        const auto start = std::chrono::steady_clock::now();
        const Result<SourceImage> image = read_image(path, {});
        CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
        CHECK(worker_peak_mib() < 512);
        if (path.filename().string().starts_with("edge_")) CHECK(image);
        if (!image) check_refusal(image.error(), path);
    }
}

} // namespace

TEST_CASE("hostile images of this repository") { check_folder(fs::path(RELIEFBAKE_TEST_DATA) / "hostile"); }

TEST_CASE("every truncation of a valid image") {
    const fs::path whole = fs::path(RELIEFBAKE_TEST_DATA) / "hostile/edge_pngsuite_basi0g16.png";
    std::ifstream in(whole, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    REQUIRE(bytes.size() > 200);
    const fs::path cut = fs::temp_directory_path() / ("reliefbake-cut-" + std::to_string(::getpid()) + ".png");
    for (std::size_t length = 0; length < bytes.size() - 16; ++length) {
        std::ofstream(cut, std::ios::binary).write(bytes.data(), std::streamsize(length));
        const Result<SourceImage> image = read_image(cut, {});
        CAPTURE(length);
        REQUIRE_FALSE(image);
        check_refusal(image.error(), cut);
    }
    fs::remove(cut);
}

TEST_CASE("hostile images of the shared set") {
    if (!fs::exists(shared_data() / "hostile")) {
        std::cout << "SKIPPED: no " << shared_data() << "; RELIEFBAKE_DATA names the large test set\n";
        return;
    }
    check_folder(shared_data() / "hostile");
    check_folder(shared_data() / "hostile_made");
}

TEST_CASE("all height maps and shapes of the shared set decode") {
    if (!fs::exists(shared_data() / "heights")) {
        std::cout << "SKIPPED: no " << shared_data() << "; RELIEFBAKE_DATA names the large test set\n";
        return;
    }
    for (const char* folder : {"heights", "shapes"})
        for (const fs::path& path : files_in(shared_data() / folder)) {
            const Result<SourceImage> image = read_image(path, {});
            INFO(path << (image ? "" : image.error().message));
            CHECK(image);
        }

    // Facts of MANIFEST.md, measured with another program: height in alpha, floats in metres, half, min-is-white, 16 bits.
    const auto check_range = [](const char* name, const char* channel, float low, float high, float margin) {
        const Result<SourceImage> image = read_image(shared_data() / name, {channel, 0});
        REQUIRE(image);
        const auto [least, largest] = std::minmax_element(image->plane.begin(), image->plane.end());
        CAPTURE(name);
        CHECK(*least == Approx(low).margin(margin));
        CHECK(*largest == Approx(high).margin(margin));
    };
    check_range("heights/pom_four_NM_height.tga", "A", 0.15686f, 1, 1e-5f);
    check_range("heights/pom_saint_NM_height.tga", "A", 0.27843f, 1, 1e-5f);
    check_range("heights/gz_dem_landscape_200x125.tif", "", -4.7325f, 921.45f, 5e-3f);
    check_range("heights/terrain3d_brush_terrain1_half.exr", "R", 2.1458e-6f, 1, 1e-9f);
    check_range("heights/polyhaven_metal_plate_disp_1k.png", "", 0.0018616f, 0.99117f, 5e-6f);
    check_range("shapes/kenney_wrench_alpha.png", "A", 0, 1, 0);
    CHECK(read_image(shared_data() / "shapes/libtiff_miniswhite-1c-1b.tiff", {})->bit_depth == 1);
    CHECK(read_image(shared_data() / "heights/bevy_parallax_cube_depth_348.png", {})->srgb_tagged);
    CHECK_FALSE(read_image(shared_data() / "heights/puget_sound_ps_height_1k.png", {})->srgb_tagged);
}

#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <string>

using namespace reliefbake::test;

namespace {

std::string baked(const std::string& extension, const std::string& options, const std::string& environment) {
    const std::string file = "same." + extension;
    const Outcome outcome = run_tool(
        "cone " + height_map("gz_dem_landscape_200x125.tif") + " -o " + file + " " + options, environment);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return bytes_of(work_folder() / file);
}

} // namespace

TEST_CASE("The same bytes for every thread count, locale, time zone and moment") {
    for (const std::string extension : {"png", "tif", "exr"}) {
        INFO(extension);
        const std::string reference = baked(extension, "--threads 1", "");
        CHECK_FALSE(reference.empty());
        CHECK(baked(extension, "--threads 2", "") == reference);
        CHECK(baked(extension, "--threads 2", "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8") == reference);
        CHECK(baked(extension, "", "TZ=Pacific/Kiritimati") == reference);
        run_tool("--version", "sleep 1.1;");
        CHECK(baked(extension, "", "") == reference);
    }
}

TEST_CASE("The same bytes where numbers are written with a comma") {
    // localedef makes a real one: the machine may have none, and an unknown LC_ALL changes nothing.
    const std::string folder = work_folder().string();
    const std::string make = "localedef -i de_DE -f UTF-8 '" + folder + "/de_DE.UTF-8' >/dev/null 2>&1";
    if (std::system(make.c_str()) != 0) {
        WARN("SKIPPED: localedef cannot make a locale here");
        return;
    }
    CHECK(baked("exr", "--scale 0.5", "LOCPATH='" + folder + "' LC_ALL=de_DE.UTF-8") == baked("exr", "--scale 0.5", ""));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("The same bytes on another day of another year") {
    if (std::system("faketime -f '+400d' true >/dev/null 2>&1") != 0) {
        WARN("SKIPPED: faketime is missing");
        return;
    }
    for (const std::string extension : {"png", "tif", "exr"})
        CHECK(baked(extension, "", "faketime -f '+400d'") == baked(extension, "", ""));
}
#endif

TEST_CASE("The same bytes on a machine without AVX2 and FMA") {
    // glibc chooses its functions by these; the SIMD code of the bake has a test of its own (laws_cones).
    const std::string masked = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA";
    for (const std::string encoding : {"ratio", "sqrt", "radius", "normal"})
        CHECK(baked("exr", "--encoding " + encoding, masked) == baked("exr", "--encoding " + encoding, ""));
}

TEST_CASE("An option given its default value changes no byte") {
    CHECK(baked("png", "--depth-uv 0.1 --bits 16 --encoding sqrt --wrap auto --range auto", "") ==
          baked("png", "", ""));
}

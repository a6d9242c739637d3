#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

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

TEST_CASE("An option given its default value changes no byte") {
    CHECK(baked("png", "--depth-uv 0.1 --bits 16 --encoding sqrt --wrap auto --range auto", "") ==
          baked("png", "", ""));
}

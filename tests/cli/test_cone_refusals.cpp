#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <string>

using namespace reliefbake::test;

namespace {

struct Refusal {
    const char* arguments; ///< after "cone IN"
    int status;
    const char* names; ///< what stderr must contain
};

void check_refused(const std::string& input, const Refusal& refusal) {
    INFO(refusal.arguments);
    const Outcome outcome = run_tool("cone " + input + " " + refusal.arguments);
    CHECK(outcome.status == refusal.status);
    CHECK(outcome.err.find(refusal.names) != std::string::npos);
    CHECK(outcome.out.empty());
    CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.png"));
    CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.exr"));
}

} // namespace

TEST_CASE("Values outside their sets and ranges are refused with what was expected") {
    const Refusal refusals[] = {
        {"-o refused.png --encoding cube", 2, "ratio|sqrt|radius|normal"},
        {"-o refused.png --bits 12", 2, "8|16|half|float"},
        {"-o refused.png --wrap mirror", 2, "repeat|clamp|auto"},
        {"-o refused.png --wrap repeat,", 2, "repeat|clamp|auto"},
        {"-o refused.png --range 1:0", 2, "LO below HI"},
        {"-o refused.png --range 0..1", 2, "LO:HI"},
        {"-o refused.png --range 0:255", 2, "code / largest code"},
        {"-o refused.png --no-data 0.5", 2, "whole numbers"},
        {"-o refused.png --range 0:nan", 2, "number"},
        {"-o refused.png --tolerance -1", 2, "0 to 1"},
        {"-o refused.png --tolerance 0.1x", 2, "0 to 1"},
        {"-o refused.png --cone-max 0", 2, "greater than 0"},
        {"-o refused.png --depth-uv inf", 2, "greater than 0"},
        {"-o refused.png --depth-uv 1e7", 2, "1e6 texture widths"},
        {"-o refused.png --pixel-aspect 0.49", 2, "resample the image"},
        {"-o refused.png --pixel-aspect 2.1", 2, "resample the image"},
        {"-o refused.png --threads 0", 2, "--threads"},
        {"-o refused.png --size 2 --depth 10cm", 2, "unit"},
        {"-o refused.png --size 2in --depth 10cm", 2, "unit"},
        {"-o refused.png --channel Q", 65, "Q"},
    };
    for (const Refusal& refusal : refusals)
        check_refused(height_map("pom_rocks_NM_height.tga"), refusal);
}

TEST_CASE("Options that do not fit each other are refused, not ignored") {
    const Refusal refusals[] = {
        {"-o refused.png --size 2m", 2, "--depth"},
        {"-o refused.png --depth 2cm", 2, "--size"},
        {"-o refused.png --depth-uv 0.1 --size 2m --depth 1cm", 2, "--depth-uv"},
        {"-o refused.png --json --quiet", 2, "--quiet"},
        {"-o refused.png --exr-layout rgba", 2, "--exr-layout"},
        {"-o refused.png --bits half", 2, "png"},
        {"-o refused.exr --bits 8", 2, "exr"},
        {"-o refused.jpg", 2, "jpg"},
        {"-o refused.png --cone-max inf", 2, "--encoding normal"},
        {"-o refused.png --cone-max inf --encoding radius", 2, "--bits half|float"},
        {"-o no/such/folder/refused.png", 73, "no/such/folder"},
    };
    for (const Refusal& refusal : refusals)
        check_refused(height_map("gz_dem_squared_129.tif"), refusal);
}

TEST_CASE("Bad inputs have their own status") {
    check_refused("missing.png", {"-o refused.png", 66, "missing.png"});
    run_tool("--help");
    check_refused("stdout", {"-o refused.png", 65, "stdout"});
    check_refused(height_map("gz_dem_squared_129.tif"), {"-o refused.png --range 0:100", 65, "--range data"});
    check_refused(height_map("pom_rocks_NM_height.tga"),
                  {"-o refused.png --channel A --scale 2", 65, "0..1"});
}

TEST_CASE("The output is never the input") {
    std::filesystem::copy_file(std::string(RELIEFBAKE_TEST_DATA) +
                                   "/heights/bevy_parallax_cube_depth_348.png",
                               work_folder() / "own.png");
    std::filesystem::create_symlink("own.png", work_folder() / "link.png");
    const std::string before = bytes_of(work_folder() / "own.png");
    CHECK(run_tool("cone own.png -o ./own.png").status == 2);
    CHECK(run_tool("cone own.png -o link.png").status == 2);
    CHECK(bytes_of(work_folder() / "own.png") == before);
}

TEST_CASE("A thread variable that is no number is refused, an empty or zero one is skipped") {
    const std::string bake = "cone " + height_map("gz_dem_squared_129.tif") + " -o threads.png --json";
    const Outcome refused = run_tool(bake, "RELIEFBAKE_THREADS=many");
    CHECK(refused.status == 2);
    CHECK(refused.err.find("RELIEFBAKE_THREADS") != std::string::npos);
    CHECK(run_tool(bake, "RELIEFBAKE_THREADS= OPENIMAGEIO_THREADS=0 CUE_THREADS=1")
              .out.find("\"threads\": 1") != std::string::npos);
    CHECK(run_tool(bake + " --threads 2", "RELIEFBAKE_THREADS=1").out.find("\"threads\": 2") !=
          std::string::npos);
}

#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <string>

using namespace reliefbake::test;

TEST_CASE("explain tells how to decode what was baked") {
    const std::string dem = height_map("gz_dem_landscape_200x125.tif");
    REQUIRE(run_tool("cone " + dem + " -o told.tif --encoding radius --metric l1 --normal-y dx").status == 0);
    const std::string text = run_tool("explain told.tif").out;
    CHECK(text.find("A > 0.0 ? B / A : 1;") != std::string::npos);
    CHECK(text.find("abs(dir.x) + abs(0.625 * dir.y)") != std::string::npos);
    CHECK(text.find("y points down the image (dx)") != std::string::npos);
    CHECK(text.find("clamp in u, clamp in v") != std::string::npos);
    CHECK(text.find("guarantee C") != std::string::npos);
}

TEST_CASE("Flags win over metadata") {
    REQUIRE(run_tool("cone " + height_map("gz_dem_squared_129.tif") + " -o hinted.png").status == 0);
    const std::string text = run_tool("explain hinted.png --encoding ratio --cone-max 2 --wrap repeat").out;
    CHECK(text.find("ratio = B * 2;") != std::string::npos);
    CHECK(text.find("repeat in u, repeat in v") != std::string::npos);
    CHECK(run_tool("explain hinted.png --channel-order RGGA").status == 2);
    CHECK(run_tool("explain hinted.png --channel-order RGB").status == 2);
}

TEST_CASE("A picture that is no map is refused with the flags that would make it one") {
    const Outcome outcome = run_tool("explain " + height_map("pom_rocks_NM_height.tga"));
    CHECK(outcome.status == 65);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("--encoding") != std::string::npos);
    CHECK(run_tool("explain missing.png").status == 66);
}

TEST_CASE("shader prints what decodes the file, in the language asked for") {
    REQUIRE(run_tool("cone " + height_map("gz_dem_squared_129.tif") + " -o shown.png").status == 0);
    const Outcome glsl = run_tool("shader --for shown.png");
    CHECK(glsl.status == 0);
    CHECK(glsl.err.empty());
    CHECK(glsl.out.starts_with("#version 330 core"));
    CHECK(run_tool("shader --for shown.png --language glsl-es").out.starts_with("#version 300 es"));
    CHECK(run_tool("shader --for shown.png --language hlsl").out.find("SV_Target") != std::string::npos);
    CHECK(run_tool("shader --for shown.png --language wgsl").status == 2);
    CHECK(run_tool("shader --for missing.png").status == 66);
    CHECK(run_tool("shader --for shown.png --channel-order RG-A").status == 2);
}

TEST_CASE("render refuses options that its technique does not use") {
    REQUIRE(run_tool("cone " + height_map("gz_dem_squared_129.tif") + " -o drawn.png").status == 0);
    const std::string render = "render drawn.png -o picture.png --size 16x16 ";
    CHECK(run_tool(render + "--technique relaxed --steps 15 --binary-steps 8 --shadow --ao cone").status == 0);
    CHECK(run_tool(render + "--technique max-mip --shadow cone-soft").status == 0);
    for (const char* refused : {"--technique parallax --steps 4", "--binary-steps 4", "--technique linear --exact-finish",
                                "--shadow soft", "--ao sky", "--technique cones"}) {
        INFO(refused);
        CHECK(run_tool(render + refused).status == 2);
    }
}

TEST_CASE("explain --histogram counts every cone once") {
    const std::string dem = height_map("gz_dem_squared_129.tif");
    REQUIRE(run_tool("cone " + dem + " -o counted.exr").status == 0);
    REQUIRE(run_tool("acm " + dem + " -o counted4.exr").status == 0);
    const auto total = [](const nlohmann::json& counted) {
        std::uint64_t sum = counted.at("wider").get<std::uint64_t>();
        for (const auto& count : counted.at("counts")) sum += count.get<std::uint64_t>();
        return sum;
    };
    const auto one = nlohmann::json::parse(run_tool("explain counted.exr --json --histogram 16").out).at("ratio_histogram");
    const auto four = nlohmann::json::parse(run_tool("explain counted4.exr --json --histogram 16").out).at("ratio_histogram");
    CHECK(one.at("each").at("counts").size() == 16);
    CHECK(total(one.at("each")) == 129 * 129);
    CHECK_FALSE(one.contains("widest"));
    CHECK(total(four.at("each")) == 4 * 129 * 129);
    CHECK(total(four.at("mean")) == 129 * 129);
    // A sector's cone is limited by fewer texels than the one cone.
    CHECK(four.at("mean").at("mean") > one.at("each").at("mean"));
    CHECK(four.at("widest").at("mean") > four.at("mean").at("mean"));
    CHECK(std::abs(four.at("each").at("mean").get<double>() - four.at("mean").at("mean").get<double>()) < 1e-9);
    CHECK(run_tool("explain counted.exr --histogram 16").status == 2);
    CHECK(run_tool("explain counted.exr --json --histogram 0").status == 2);
    REQUIRE(run_tool("bump " + dem + " -o counted_bump.png --kind normal").status == 0);
    CHECK(run_tool("explain counted_bump.png --json --histogram 16").status == 2);
}

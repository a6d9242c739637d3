#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

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

#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

std::string dem() { return height_map("gz_dem_landscape_200x125.tif"); }

json bake(const std::string& arguments, const std::string& command = "cone") {
    const Outcome outcome = run_tool(command + " " + arguments + " --json");
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
}

} // namespace

TEST_CASE("A chain lists its levels, and each is read, explained and safe") {
    const json schema = json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/cone.schema.json"));
    for (const std::string file : {"chain.exr", "chain.tif"})
        for (const std::string blend : {"", " --trilinear"}) {
            CAPTURE(file, blend);
            const json result = bake(dem() + " -o " + file + " --mips" + blend);
            CHECK(schema_fault(result, schema) == "");
            REQUIRE(result["levels"].size() == 8);
            CHECK(result["levels"][1]["width"] == 100);
            CHECK(result["levels"][1]["height"] == 62);
            CHECK(result["map"]["levels"] == 8);
            CHECK(result["map"].contains("trilinear") == !blend.empty());
            const std::string text = run_tool("explain " + file).out;
            CHECK(text.find("8 mip levels") != std::string::npos);
            for (const int level : {0, 1, 3, 7}) {
                CAPTURE(level);
                const Outcome judged = run_tool("verify " + file + " --json --rays 3000 --points 800 --crop 0 --level " +
                                                std::to_string(level));
                INFO(judged.err);
                CHECK(judged.status == 0);
            }
            CHECK(run_tool("verify " + file + " --level 8").status == 65);
        }
}

TEST_CASE("A level's proportions are the map's") {
    bake(dem() + " -o shape.exr --mips");
    const json top = json::parse(run_tool("explain shape.exr --json").out);
    const json level = json::parse(run_tool("explain shape.exr --json --level 2").out);
    CHECK(level["width"] == 50);
    CHECK(level["height"] == 31);
    CHECK(level["aspect"].get<double>() == Approx(top["aspect"].get<double>()));
    CHECK(level["statistics"].empty());
    CHECK(run_tool("render shape.exr -o shape.png --size 32x24 --level 2").status == 0);
}

TEST_CASE("A chain in PNG is numbered files, each a map") {
    const json result = bake(dem() + " -o many.png --mips --trilinear");
    CHECK(result["levels"][0]["output"] == "many.png");
    CHECK(result["levels"][7]["output"] == "many_mip7.png");
    for (const json& level : result["levels"]) {
        const std::string file = level["output"];
        CAPTURE(file);
        const json map = json::parse(run_tool("explain --json " + file).out);
        CHECK(map["width"] == level["width"]);
        CHECK(map["trilinear"] == true);
        CHECK(map["statistics"] == level["statistics"]);
    }
    CHECK(run_tool("verify many_mip3.png --rays 3000 --points 800 --crop 0").status == 0);
}

TEST_CASE("Maps without square texels have safe levels too") {
    write_pgm(work_folder() / "slim.pgm", 15, 16, [](int x, int y) { return (x * 89 + y * 57) % 256; });
    bake("slim.pgm -o slim.exr --mips --pixel-aspect 0.6 --wrap repeat --trilinear");
    for (int level = 0; level < 5; ++level)
        CHECK(run_tool("verify slim.exr --rays 2000 --points 2000 --crop 0 --level " + std::to_string(level)).status == 0);
}

TEST_CASE("Chains of sectors and of stacks are safe on every level") {
    const json schema = json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/cone.schema.json"));
    for (const std::string command : {"acm --sectors 4 --trilinear", "acm --sectors 8 --kind relaxed", "cone-stack --levels 3 --trilinear",
                                      "cone-stack --levels 5 --method 2"}) {
        CAPTURE(command);
        const json result = bake(dem() + " -o planes.exr --mips", command);
        CHECK(schema_fault(result, schema) == "");
        REQUIRE(result["levels"].size() == 8);
        for (const int level : {0, 1, 3, 6, 7}) { // the last ones are 3 x 1 and 1 x 1
            CAPTURE(level);
            const Outcome judged = run_tool("verify planes.exr --json --rays 3000 --points 800 --crop 0 --level " + std::to_string(level));
            INFO(judged.out << judged.err);
            CHECK(judged.status == 0);
        }
    }
}

TEST_CASE("Cones alone are chains in two files or more, with a chain of reliefs beside them") {
    const json result = bake(dem() + " -o eight.png --relief ground.tif --sectors 8 --mips", "acm");
    CHECK(result["levels"][2]["output"] == "eight_mip2.png");
    CHECK(std::filesystem::exists(work_folder() / "eight_mip2_b.png"));
    CHECK(run_tool("verify ground.tif --level 2 --rays 2000 --points 800 --crop 0").status == 0);
    bake(dem() + " -o four.tif --relief floor.tif --mips", "acm");
    CHECK(run_tool("verify four.tif --relief floor.tif --level 2 --rays 2000 --points 800 --crop 0").status == 0);
    CHECK(run_tool("acm " + dem() + " -o four.png --relief four_mip1.png --mips").status == 2);
    for (const std::string file : {"four.dds", "four.ktx2"}) bake(dem() + " -o " + file + " --mips --bits 8", "acm");
}

TEST_CASE("DDS and KTX2 are written at every depth, and reading them is refused with a line") {
    for (const std::string file : {"texture.dds", "texture.ktx2"})
        for (const std::string bits : {"8", "16", "half", "float"}) bake(dem() + " -o " + file + " --mips --bits " + bits);
    const Outcome outcome = run_tool("explain texture.ktx2");
    CHECK(outcome.status == 65);
    CHECK(outcome.err.find("written, not read") != std::string::npos);
}

TEST_CASE("A blend that keeps no guarantee is refused") {
    for (const std::string arguments : {"--trilinear", "--mips --trilinear --surface texel"}) {
        const Outcome outcome = run_tool("cone " + dem() + " -o refused.exr " + arguments);
        CAPTURE(arguments);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find("--trilinear") != std::string::npos);
    }
    for (const std::string command : {"acm --method adaptive --trilinear", "cone-stack --method 2 --trilinear", "acm --sectors 8 --layout side"}) {
        CAPTURE(command);
        CHECK(run_tool(command + " " + dem() + " -o refused.exr --mips").status == 2);
    }
    CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.exr"));
    bake(dem() + " -o single.png");
    CHECK(run_tool("verify single.png --level 1").status == 2);
}

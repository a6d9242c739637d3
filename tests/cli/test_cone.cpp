#include "tests/cli/json_schema.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

json bake(const std::string& arguments) {
    const Outcome outcome = run_tool("cone " + arguments + " --json");
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    const json result = json::parse(outcome.out);
    CHECK(outcome.err.empty() == result["warnings"].empty());
    return result;
}

json explain(const std::string& arguments) {
    const Outcome outcome = run_tool("explain --json " + arguments);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
}

} // namespace

TEST_CASE("Every encoding in every depth of every format says what it is") {
    const char* outputs[][2] = {{"png", "8"},    {"png", "16"},    {"tif", "8"},    {"tif", "16"},
                                {"tif", "half"}, {"tif", "float"}, {"exr", "half"}, {"exr", "float"}};
    for (const auto& [extension, bits] : outputs)
        for (const std::string encoding : {"ratio", "sqrt", "radius", "normal"}) {
            const std::string file = std::string("map.") + extension;
            // Code 0 is lawful and warned about at 8 bits: only there may stderr speak.
            const Outcome outcome = run_tool("cone " + height_map("gz_dem_squared_129.tif") + " -o " + file +
                                             " --bits " + bits + " --encoding " + encoding + " --json");
            INFO(file << " " << bits << " " << encoding << " " << outcome.err);
            REQUIRE(outcome.status == 0);
            const json result = json::parse(outcome.out);
            CHECK(outcome.err.empty() == (result["statistics"]["zero_codes"] == 0));
            const json map = explain(file);
            CHECK(map == result["map"]);
            CHECK(map["encoding"] == encoding);
            CHECK((map["bits"].is_string() ? map["bits"].get<std::string>() : map["bits"].dump()) == bits);
        }
}

TEST_CASE("The result object is what its schema says") {
    const json result = bake(height_map("ambientcg_RoofingTiles009_512.png") + " -o roof.png");
    const json schema = json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/cone.schema.json"));
    CHECK(schema_fault(result, schema) == "");
    CHECK(result["wrap"] == json({"repeat", "repeat"}));
    CHECK(result["source"]["bit_depth"] == 16);
    CHECK(result["statistics"]["zero_codes"] == 0);

    json broken = result;
    broken["seconds"].erase("write");
    CHECK(schema_fault(broken, schema) == "$.seconds.write: missing");
    broken = result;
    broken["wrap"][1] = "mirror";
    CHECK(schema_fault(broken, schema) == "$.wrap[1]: not one of the words");
}

TEST_CASE("A DEM in metres takes its extremes, clamps, and keeps its shape") {
    const json result =
        bake(height_map("gz_dem_landscape_200x125.tif") + " -o dem.exr --size 30m --depth 60cm");
    CHECK(result["range"]["from_data"] == true);
    CHECK(result["range"]["high"].get<double>() == Approx(921.448));
    CHECK(result["wrap"] == json({"clamp", "clamp"}));
    CHECK(result["map"]["depth_scale"].get<double>() == Approx(0.02));
    CHECK(result["map"]["aspect"].get<double>() == Approx(0.625));
    CHECK(result["map"]["bits"] == "float");
}

TEST_CASE("Height in alpha, and depth maps, are turned the right way") {
    const json rocks = bake(height_map("pom_rocks_NM_height.tga") + " --channel A -o rocks.png");
    CHECK(rocks["source"]["channel"] == "A");
    CHECK(rocks["statistics"]["depth_max"].get<double>() == Approx(1).margin(1e-4));
    const std::string cube = height_map("bevy_parallax_cube_depth_348.png");
    const json as_depth = bake(cube + " --input depth --scale 0.5 --bias 0.5 -o cube.png");
    CHECK(as_depth["statistics"]["depth_min"].get<double>() == 0);
    CHECK(as_depth["statistics"]["depth_max"].get<double>() == Approx(0.5).margin(1e-4));
    CHECK(as_depth["warnings"][0].get<std::string>().find("sRGB") != std::string::npos);
    const json as_height = bake(cube + " --scale 0.5 --bias 0.5 -o cube.png");
    CHECK(as_height["map"]["argument_hash"] != as_depth["map"]["argument_hash"]);
    CHECK(as_height["map"]["source_hash"] == as_depth["map"]["source_hash"]);
}

TEST_CASE("The named layout has the names that scripts rely on") {
    const json result = bake(height_map("terrain3d_terrain1_crop128_half.exr") +
                             " -o named.exr --exr-layout named --encoding ratio --bits float");
    CHECK(result["map"]["channels"] == json({"relief.nx", "relief.ny", "relief.cone", "relief.depth"}));
    CHECK(explain("named.exr")["layout"] == "named");
}

TEST_CASE("Wrap, metric and surface are kept per axis and as told") {
    const json map =
        bake(height_map("gz_dem_squared_129.tif") +
             " -o told.png --wrap repeat,clamp --metric l1 --surface texel --normal-y dx")["map"];
    CHECK(map["wrap"] == json({"repeat", "clamp"}));
    CHECK(map["metric"] == "l1");
    CHECK(map["surface"] == "texel");
    CHECK(map["normal_y"] == "dx");
}

TEST_CASE("Lost cones are counted, and the warning names an encoding that loses fewer") {
    const std::string bake =
        "cone " + height_map("ambientcg_RoofingTiles009_512.png") + " -o lost.png --bits 8";
    const Outcome lost = run_tool(bake + " --encoding ratio --cone-max 8");
    CHECK(lost.status == 0);
    CHECK(lost.err.find("reliefbake cone: warning: lost.png") == 0);
    CHECK(lost.err.find("--encoding sqrt loses 0") != std::string::npos);
    CHECK(run_tool(bake + " --encoding sqrt").err == "");
}

TEST_CASE("A warning begins with the command whose map it is about, in --also as well") {
    const std::string roof = height_map("ambientcg_RoofingTiles009_512.png"), lossy = " --bits 8 --encoding ratio --cone-max 8";
    const Outcome both = run_tool("acm " + roof + " -o acm.png --relief acm_cone.png" + lossy + " --quiet --also 'cone-stack --levels 2 -o stack.png --relief stack_cone.png" + lossy + "'");
    INFO(both.err);
    CHECK(both.status == 0);
    CHECK(both.err.find("reliefbake acm: warning: acm.png") != std::string::npos);
    CHECK(both.err.find("reliefbake cone-stack: warning: stack.png") != std::string::npos);
    CHECK(both.err.find("reliefbake cone:") == std::string::npos);
}

TEST_CASE("Unbounded cones are taken where a code for them exists") {
    const json map =
        bake(height_map("gz_dem_squared_129.tif") + " -o inf.exr --encoding normal --cone-max inf")["map"];
    CHECK(map["cone_max"] == "inf");
}

TEST_CASE("Numbers are told as people write them, and infinity as a word") {
    const json roof = bake(height_map("gz_dem_squared_129.tif") + " -o told.png --cone-max 0.3");
    CHECK(roof["map"]["tolerance"].dump() == "0.001");
    CHECK(roof["map"]["cone_max"].dump() == "0.3");
    // A flat map has nothing above it: without a cap, none of its cones has a bound.
    const json flat = bake(height_map("gz_dem_squared_129.tif") +
                           " -o flat.exr --encoding normal --cone-max inf --scale 0 --bias 1");
    const json schema = json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/cone.schema.json"));
    CHECK(schema_fault(flat, schema) == "");
    CHECK(flat["statistics"]["ratio_mean"] == "inf");
    CHECK(explain("flat.exr") == flat["map"]);
}

TEST_CASE("A boundless budget is a budget") {
    for (const std::string bytes : {"18446744073709551615", "1024GB"})
        bake(height_map("gz_dem_squared_129.tif") + " -o budget.png --max-bytes " + bytes);
}

TEST_CASE("stdout holds the summary, --quiet nothing") {
    const std::string arguments = "cone " + height_map("gz_dem_squared_129.tif") + " -o quiet.png";
    const Outcome loud = run_tool(arguments);
    CHECK(loud.out.find("wrap clamp, clamp") != std::string::npos);
    CHECK(loud.err == "");
    const Outcome quiet = run_tool(arguments + " --quiet");
    CHECK(quiet.status == 0);
    CHECK(quiet.out == "");
    CHECK(quiet.err == "");
}

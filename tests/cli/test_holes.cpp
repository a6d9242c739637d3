#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

constexpr int side = 48;

/// Waves, and a mask with three holes: 10 x 8 texels, one texel wide, and one that is half grey.
void write_inputs() {
    write_pgm(work_folder() / "waves.pgm", side, side,
              [](int x, int y) { return int(128 + 60 * std::sin(x * 0.5) + 60 * std::cos(y * 0.35)); });
    write_pgm(work_folder() / "mask.pgm", side, side, [](int x, int y) {
        if (x >= 10 && x < 20 && y >= 6 && y < 14) return 0;
        if (x == 30 && y >= 20 && y < 40) return 0;
        return x >= 34 && x < 44 && y >= 30 && y < 40 ? 100 : 255;
    });
}

json bake(const std::string& arguments) {
    const Outcome outcome = run_tool(arguments + " --json");
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
}

json judged(const std::string& arguments) {
    const Outcome outcome = run_tool("verify " + arguments + " --json --rays 8000 --points 1500 --crop 0");
    INFO(arguments << "\n" << outcome.err << outcome.out.substr(0, 400));
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
}

} // namespace

TEST_CASE("--alpha FILE cuts holes: counted, told, judged, and discarded by the shader") {
    write_inputs();
    const json schema = json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/cone.schema.json"));
    const json result = bake("cone waves.pgm -o holes.png --wrap repeat --alpha mask.pgm");
    CHECK(schema_fault(result, schema) == "");
    CHECK(result["statistics"]["hole_texels"] == 80 + 20 + 100);
    CHECK(result["statistics"]["open_cells"] == 9 * 7 + 9 * 9);
    CHECK(result["map"]["holes"] == true);
    CHECK(result["map"]["alpha_hash"].get<std::string>().size() == 32);
    CHECK(bake("cone waves.pgm -o holes2.png --wrap repeat --alpha mask.pgm --alpha-threshold 0.3")["statistics"]["hole_texels"] == 100);

    CHECK(json::parse(run_tool("explain holes.png --json").out)["holes"] == true);
    CHECK(run_tool("explain holes.png").out.find("is a hole") != std::string::npos);
    const json report = judged("holes.png");
    CHECK(report["missed"] == 0);
    CHECK(report["pierced"] == 0);
    CHECK(report["filled"] == 0);
    CHECK(report["holes"] > 0.01);
    for (const std::string language : {"glsl", "glsl-es", "hlsl"})
        CHECK(run_tool("shader --for holes.png --language " + language).out.find("discard;") != std::string::npos);

    bake("cone waves.pgm -o whole.png --wrap repeat");
    CHECK_FALSE(json::parse(run_tool("explain whole.png --json").out).contains("holes"));
    CHECK(run_tool("shader --for whole.png").out.find("discard") == std::string::npos);
    CHECK(judged("whole.png")["holes"] == 0);
}

TEST_CASE("--alpha CHANNEL takes the holes from the input itself") {
    const json result = bake("cone " + height_map("pom_rocks_NM_height.tga") + " --channel R --alpha A --alpha-threshold 0.2 -o rocks.png");
    CHECK(result["statistics"]["hole_texels"] > 0);
    CHECK(result["statistics"]["hole_texels"] < 0.9 * result["map"]["width"].get<double>() * result["map"]["height"].get<double>());
}

TEST_CASE("every family bakes holes that verify finds right") {
    write_inputs();
    const std::string source = " waves.pgm --alpha mask.pgm --wrap clamp ";
    for (const std::string command : {"cone -o family.exr", "cone -o family.exr --bits half --encoding ratio", "cone -o family.png --bits 8",
                                      "cone -o family.exr --lookup cell", "cone -o family.exr --metric l1",
                                      "cone -o family.exr --kind relaxed", "cone -o family.exr --kind hybrid --delta 0.05",
                                      "acm -o family.exr --sectors 4", "acm -o family.exr --sectors 8 --kind relaxed",
                                      "cone-normal -o family.exr", "cone-stack -o family.exr --levels 3", "cone-stack -o family.exr --levels 3 --method 2"}) {
        CAPTURE(command);
        const std::size_t space = command.find(' ');
        bake(command.substr(0, space) + source + command.substr(space));
        const json report = judged(command.find(".png") != std::string::npos ? "family.png" : "family.exr");
        CHECK(report["missed"] == 0);
        CHECK(report["violations"] == 0);
        CHECK(report["pierced"] == 0);
        CHECK(report["filled"] == 0);
        CHECK(report["holes"] > 0.01);
    }
}

TEST_CASE("levels of a chain have holes of their own, safe to blend") {
    write_inputs();
    const json result = bake("cone waves.pgm --alpha mask.pgm -o holes.tif --mips --trilinear");
    CHECK(result["levels"][1]["statistics"]["open_cells"] > 20);
    for (const int level : {1, 2, 3}) CHECK(judged("holes.tif --level " + std::to_string(level))["pierced"] == 0);
}

TEST_CASE("cones alone keep their holes in the relief file, and another's are refused") {
    write_inputs();
    bake("acm waves.pgm --wrap repeat --alpha mask.pgm -o sectors.png --relief relief.png");
    CHECK(judged("sectors.png --relief relief.png")["holes"] > 0.01);
    bake("cone waves.pgm --wrap repeat -o other.png");
    const Outcome refused = run_tool("verify sectors.png --relief other.png");
    CHECK(refused.status == 65);
    CHECK(refused.err.find("other holes") != std::string::npos);
}

TEST_CASE("what lies under a hole is nobody's height") {
    write_inputs();
    const auto is_hole = [](int x, int y) { return x >= 10 && x < 20 && y >= 6 && y < 14; };
    write_pfm(work_folder() / "survey.pfm", side, side, [&](int x, int y) {
        if (is_hole(x, y)) return x == 12 ? 1e9f : std::numeric_limits<float>::quiet_NaN();
        return 100 + 5 * float(std::sin(x * 0.3) + std::cos(y * 0.2));
    });
    const json result = bake("cone survey.pfm --alpha mask.pgm --range data -o survey.exr");
    CHECK(result["range"]["high"] < 111);
    CHECK(result["source"]["filled_texels"] == 0);
    CHECK(judged("survey.exr --source survey.pfm --range data")["depth_difference"] < 1e-6);
    CHECK(run_tool("cone survey.pfm -o refused.exr").status == 65);
}

TEST_CASE("alphas that cut no hole, only pits, or everything are baked with a warning") {
    write_inputs();
    write_pgm(work_folder() / "white.pgm", side, side, [](int, int) { return 255; });
    write_pgm(work_folder() / "black.pgm", side, side, [](int, int) { return 0; });
    write_pgm(work_folder() / "slit.pgm", side, side, [](int x, int) { return x == 7 ? 0 : 255; });
    const auto warning = [](const std::string& mask) {
        const Outcome outcome = run_tool("cone waves.pgm -o extreme.png --alpha " + mask);
        CHECK(outcome.status == 0);
        return outcome.err;
    };
    CHECK(warning("white.pgm").find("has no hole") != std::string::npos);
    CHECK(judged("extreme.png")["holes"] == 0);
    CHECK(warning("slit.pgm").find("pits") != std::string::npos);
    CHECK(judged("extreme.png")["holes"] == 0);
    CHECK(warning("black.pgm").find("all of the map") != std::string::npos);
    CHECK(judged("extreme.png")["holes"] == 1);
    CHECK(warning("mask.pgm").empty());
}

TEST_CASE("alphas that cannot be used are refused with a line") {
    write_inputs();
    write_pgm(work_folder() / "small.pgm", side, side - 1, [](int, int) { return 255; });
    write_pfm(work_folder() / "nan.pfm", side, side, [](int x, int) { return x == 3 ? std::numeric_limits<float>::quiet_NaN() : 1.0f; });
    struct Refusal {
        const char* arguments;
        int status;
        const char* names;
    };
    const Refusal refusals[] = {
        {"-o refused.png --alpha small.pgm", 65, "48 x 47"},
        {"-o refused.png --alpha nan.pfm", 65, "the first at (3, 0)"},
        {"-o refused.png --alpha B", 66, "no such channel (it has Y)"},
        {"-o refused.png --alpha missing.png", 66, "missing.png"},
        {"-o refused.png --alpha-threshold 0.5", 2, "--alpha"},
        {"-o refused.png --alpha mask.pgm --alpha-threshold 0", 2, "greater than 0"},
        {"-o refused.png --alpha mask.pgm --alpha-threshold 1.01", 2, "up to 1"},
    };
    for (const Refusal& refusal : refusals) {
        CAPTURE(refusal.arguments);
        const Outcome outcome = run_tool(std::string("cone waves.pgm ") + refusal.arguments);
        CHECK(outcome.status == refusal.status);
        CHECK(outcome.err.find(refusal.names) != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.png"));
    }
    std::filesystem::copy_file(work_folder() / "holes.png", work_folder() / "own_mask.png", std::filesystem::copy_options::overwrite_existing);
    const Outcome own = run_tool("cone waves.pgm -o own_mask.png --alpha own_mask.png");
    CHECK(own.status == 2);
    CHECK(own.err.find("is the input file") != std::string::npos);
}

TEST_CASE("a file without metadata has holes when told so") {
    write_inputs();
    bake("cone waves.pgm --alpha mask.pgm -o holes.tga --wrap repeat");
    const std::string hints = "holes.tga --channel-order RGBA --metric l2 --encoding sqrt --surface bilinear --wrap repeat --cone-max 1";
    CHECK(judged(hints)["holes"] == 0);
    CHECK(judged(hints + " --holes")["holes"] > 0.01);
}

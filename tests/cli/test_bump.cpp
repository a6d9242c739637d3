#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

const char* const kinds[] = {"derivative", "normal", "horizon"};

/// A small map that tiles, for quick bakes.
std::string small_map() {
    static const bool written = [] {
        run_tool("--version"); // makes the folder
        write_pgm(work_folder() / "small.pgm", 24, 16, [](int x, int y) { return 128 + 60 * ((x / 4 + y / 4) % 2) + (x * 7 + y * 13) % 11; });
        return true;
    }();
    (void)written;
    return "small.pgm";
}

Outcome bump(const std::string& options) { return run_tool("bump " + small_map() + " " + options); }

} // namespace

TEST_CASE("bump bakes every kind, says so in JSON, explains it and keeps what it states") {
    const json schema = json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/bump.schema.json"));
    for (const std::string kind : kinds) {
        INFO(kind);
        const Outcome baked = bump("-o " + kind + ".exr --json --kind " + kind);
        REQUIRE(baked.status == 0);
        const json result = json::parse(baked.out);
        CHECK(schema_fault(result, schema) == "");
        CHECK(result["map"]["kind"] == kind);
        CHECK(json::parse(run_tool("explain " + kind + ".exr --json").out) == result["map"]);
        CHECK(run_tool("explain " + kind + ".exr").out.starts_with("A " + kind + " map of 24 x 16 texels"));
        const Outcome verified = run_tool("verify " + kind + ".exr --json" + (kind == "horizon" ? " --points 500 --rays 2000" : ""));
        CHECK(verified.status == 0);
        const json verdict = json::parse(verified.out);
        CHECK(verdict["verdict"] == "holds");
        CHECK(verdict["violations"] == 0);
        CHECK(verdict["bound"] == result["map"]["error"]);
        CHECK(verdict["shadows"].is_array() == (kind == "horizon"));
        CHECK(run_tool("shader --for " + kind + ".exr").out.starts_with("#version 330 core"));
        CHECK(run_tool("shader --for " + kind + ".exr --language hlsl").out.find("SV_Target") != std::string::npos);
    }
}

TEST_CASE("explain says how integers hold zero and where azimuths lie") {
    REQUIRE(bump("-o told8.png --bits 8").status == 0);
    CHECK(run_tool("explain told8.png").out.find("* 255.0 - 128.0) / 127.0") != std::string::npos);
    REQUIRE(bump("-o toldn.png --kind normal --normal-y dx").status == 0);
    CHECK(run_tool("explain toldn.png").out.find("down (DirectX)") != std::string::npos);
    REQUIRE(bump("-o toldh.png --kind horizon --pixel-aspect 0.5").status == 0);
    CHECK(run_tool("explain toldh.png").out.find("0, 26.57, 90, 153.4, 180, 206.6, 270, 333.4 degrees") != std::string::npos);
    CHECK(std::filesystem::exists(work_folder() / "toldh_b.png"));
}

TEST_CASE("horizons beside a cone map draw its shadows; others are refused") {
    REQUIRE(run_tool("cone " + small_map() + " -o drawn.png --wrap repeat").status == 0);
    REQUIRE(bump("-o sky.png --kind horizon --wrap repeat").status == 0);
    const std::string render = "render drawn.png -o picture.png --size 24x24 ";
    CHECK(run_tool(render + "--shadow horizon --horizon sky.png").status == 0);
    CHECK(run_tool(render + "--shadow horizon").status == 2);
    CHECK(run_tool(render + "--horizon sky.png").status == 2);
    CHECK(run_tool(render + "--shadow horizon --horizon drawn.png").status == 65);
    REQUIRE(bump("-o other.png --kind horizon --wrap clamp").status == 0);
    CHECK(run_tool(render + "--shadow horizon --horizon other.png").status == 2);
    CHECK(run_tool("render drawn.png -o sky.png --shadow horizon --horizon sky.png").status == 2);
    // Two files of horizons hold no depth to be judged by.
    CHECK(run_tool("verify sky.png").status == 2);
    CHECK(run_tool("verify sky.png --relief drawn.png --points 200 --rays 2000").status == 0);
    CHECK(run_tool("verify other.png --relief drawn.png").status == 65);
    CHECK(run_tool("render sky.png -o picture.png --size 24x24").err.find("--horizon FILE") != std::string::npos);
}

TEST_CASE("options that a kind does not read are refused, and nothing is written") {
    struct Refusal {
        const char* options;
        int status;
        const char* names;
    };
    const Refusal refusals[] = {
        {"--kind slope -o refused.png", 2, "derivative|normal|horizon"},
        {"--kernel prewitt -o refused.png", 2, "central|sobel|scharr"},
        {"--kind horizon --kernel sobel -o refused.png", 2, "--kernel"},
        {"--kind horizon --codes centred -o refused.png", 2, "--codes"},
        {"--kind normal --derivative-max 3 -o refused.png", 2, "--derivative-max"},
        {"--normal-y dx -o refused.png", 2, "--normal-y"},
        {"--depth-uv 0.2 -o refused.png", 2, "--depth-uv"},
        {"--derivative-max 0.001 -o refused.png", 2, "largest derivative"},
        {"--derivative-max 3 -o refused.exr", 2, "--bits 8 and 16"},
        {"--codes unorm -o refused.exr", 2, "--bits 8 and 16"},
        {"--bits half -o refused.png", 2, "png"},
        {"-o refused.dds", 2, ".png, .tif, .exr or .tga"},
        {"--layout named -o refused.png", 2, "exr"},
        {"--layout pair -o refused.png", 2, "pair"},
        {"--kind horizon --layout rgba -o refused.png", 2, "pair or named"},
        {"-o no/such/folder/refused.png", 73, "no/such/folder"},
        {"-o small.pgm", 2, "small.pgm"},
        {"--json --quiet -o refused.png", 2, "--quiet"},
    };
    for (const Refusal& refusal : refusals) {
        INFO(refusal.options);
        const Outcome outcome = bump(refusal.options);
        CHECK(outcome.status == refusal.status);
        CHECK(outcome.err.find(refusal.names) != std::string::npos);
        CHECK(outcome.out.empty());
        CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.png"));
        CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.exr"));
    }
    REQUIRE(bump("-o kept.png").status == 0);
    for (const char* unread : {"explain kept.png --wrap clamp", "verify kept.png --technique linear", "verify kept.png --source small.pgm",
                               "verify kept.png --relief kept.png", "verify kept.png --points 10", "verify kept.png --rays 1000", "verify kept.png --seed 2",
                               "verify kept.png --renderer osmesa", "shader --for kept.png --level 1"}) {
        const Outcome outcome = run_tool(unread);
        INFO(unread << ": " << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    }
}

TEST_CASE("a damaged bump map is found by verify") {
    // A horizon map beside the cone map of the same file, whose heights were scaled on the way.
    REQUIRE(bump("-o first.png --kind horizon --wrap repeat --scale 0.9").status == 0);
    REQUIRE(run_tool("cone " + small_map() + " -o second.png --wrap repeat").status == 0);
    const Outcome outcome = run_tool("verify first.png --relief second.png --points 500 --rays 2000");
    CHECK(outcome.status == 4);
    CHECK(outcome.out.find("verdict: violated") != std::string::npos);
}

TEST_CASE("bump writes the same bytes for every thread count, locale and time zone") {
    for (const std::string kind : kinds) {
        const auto bytes = [&](const std::string& environment, const std::string& options) {
            REQUIRE(run_tool("bump " + small_map() + " -o same.tif --kind " + kind + " " + options, environment).status == 0);
            return bytes_of(work_folder() / "same.tif") + (kind == "horizon" ? bytes_of(work_folder() / "same_b.tif") : "");
        };
        const std::string reference = bytes("", "--threads 1");
        CHECK(bytes("LC_ALL=de_DE.UTF-8 TZ=Pacific/Kiritimati", "--threads 3") == reference);
        CHECK(bytes("GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA", "") == reference);
    }
}

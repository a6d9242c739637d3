// `render` and `verify` on shape maps, from outside.

#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

/// A ring, dark on bright.
void write_ring(const char* name) {
    write_pgm(work_folder() / name, 64, 48, [](int x, int y) {
        const double r = std::hypot(x - 31.5, y - 23.5);
        return r > 9 && r < 18 ? 0 : 255;
    });
}

void require_run(const std::string& arguments) {
    const Outcome outcome = run_tool(arguments);
    INFO(arguments << ": " << outcome.err);
    REQUIRE(outcome.status == 0);
}

} // namespace

TEST_CASE("a shape map verifies at every bit depth, and what verify prints is complete") {
    write_ring("ring.pgm");
    for (const std::string output : {"a.png --bits 8", "a.png --bits 16", "a.exr --bits half", "a.exr --bits float", "a.tif --bits 16 --signed", "a.png --wrap repeat",
                                     "a.png --scale-f 0.4", "a.png --model centres", "a.png --antialiased", "a.exr --bits float --antialiased --signed --wrap repeat"}) {
        require_run("shape ring.pgm --quiet -o " + output);
        const Outcome outcome = run_tool("verify " + output.substr(0, 5) + " --rays 6000 --points 1000 --json");
        INFO(output << outcome.err);
        REQUIRE(outcome.status == 0);
        const json report = json::parse(outcome.out);
        CHECK(report["verdict"] == "safe");
        CHECK(report["points"] == 1000);
        CHECK(report["violations"] == 0);
        CHECK(report["solids"].size() == 12);
        for (const json& solid : report["solids"]) {
            INFO(solid.dump());
            CHECK(solid["rays"] > 100);
            CHECK(solid["missed"] == 0);
            CHECK(solid["early"] == 0);
            CHECK(solid["not_finite"] == 0);
            CHECK(solid["out_of_steps"] == 0);
        }
    }
    CHECK(run_tool("verify a.png --rays 3000 --points 100").out.find("verdict: safe") != std::string::npos);
}

TEST_CASE("verify takes no option of other maps") {
    write_ring("ring.pgm");
    require_run("shape ring.pgm --quiet -o s.png");
    for (const std::string option : {"--technique linear", "--exact-finish", "--crop 3", "--source ring.pgm", "--metric l2"}) {
        INFO(option);
        CHECK(run_tool("verify s.png --rays 1000 --points 10 " + option).status == 2);
    }
    require_run("cone " + height_map("gz_dem_squared_129.tif") + " -o cone.png --wrap clamp --quiet");
    CHECK(run_tool("verify cone.png --e 0.1").status == 2);
    CHECK(run_tool("render cone.png -o p.png --solid revolution").status == 2);
    CHECK(run_tool("render cone.png -o p.png --view 100").status == 2);
}

TEST_CASE("render draws every kind of solid and refuses what does not fit it") {
    write_ring("ring.pgm");
    require_run("shape ring.pgm --quiet -o s.png");
    require_run("bump " + height_map("gz_dem_squared_129.tif") + " --quiet -o bump.exr");
    const std::string render = "render s.png -o p.png --size 40x30 ";
    for (const std::string options : {"", "--e 0.05", "--b 0.1", "--b 0.1 --c 0.5", "--on box --view 120", "--solid revolution --projection spherical --axis 0.2 --shadow hard",
                                      "--solid revolution --texture s.png --texture-tiles 3,2", "--bump bump.exr --bump-scale 0.2", "--scheme published --steps 30 --binary-steps 4"})
        require_run(render + options);
    for (const std::string options : {"--e -1", "--e x", "--c 0.5", "--b 0.1 --c -1", "--axis 0.2", "--solid revolution --axis 1", "--solid revolution --on plane",
                                      "--solid revolution --depth-scale 1", "--projection spherical", "--bump-scale 2", "--texture-tiles 2", "--view 95", "--tiles 2", "--on box --span 1",
                                      "--technique linear", "--endless", "--shadow cone-soft", "--ao cone", "--bump s.png", "--texture missing.png"}) {
        INFO(options);
        const Outcome outcome = run_tool(render + options);
        CHECK(outcome.status != 0);
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') <= 2);
        CHECK(!outcome.err.empty());
    }
}

TEST_CASE("shader prints a shape map's decoder in every language, with the constants that explain prints") {
    write_ring("ring.pgm");
    require_run("shape ring.pgm --quiet -o s.exr --signed --bits float");
    const json map = json::parse(run_tool("explain --json s.exr").out);
    for (const std::string language : {"glsl", "glsl-es", "hlsl"}) {
        const Outcome shader = run_tool("shader --for s.exr --language " + language);
        INFO(language << shader.err);
        CHECK(shader.status == 0);
        const std::size_t tau = shader.out.find("shape_tau = ");
        REQUIRE(tau != std::string::npos);
        CHECK(std::stod(shader.out.substr(tau + 12)) == Approx(map["tau"].get<double>()).epsilon(1e-6));
        CHECK(shader.out.find("circle_trace(ray") != std::string::npos);
    }
    CHECK(run_tool("shader --for s.exr --wrap repeat").status == 2);
}

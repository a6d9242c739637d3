// `bench surface` and `verify --mesh` from outside.

#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

void make_files() {
    write_pgm(work_folder() / "bumps.pgm", 32, 32, [](int x, int y) { return 40 + (x * x + 3 * x * y) % 11 * 8 + (y / 8 % 2) * 100; });
    for (const std::string line : {"cone bumps.pgm -o bumps.exr --wrap repeat --quiet", "bench surface cylinder --segments 64 -o cylinder.glb"}) {
        const Outcome outcome = run_tool(line);
        INFO(line << ": " << outcome.err);
        REQUIRE(outcome.status == 0);
    }
}

json report(const std::string& more) {
    const Outcome outcome = run_tool("verify bumps.exr --mesh cylinder.glb --depth-scale 0.1 --mesh-tiles 6,2 --size 200x150 --mesh-view 90,20 --json " + more);
    INFO(more << ": " << outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
}

} // namespace

TEST_CASE("verify judges a map on a mesh, with and without correction") {
    make_files();
    const json flat = report("--correction none"), bent = report("--steps 100 --ends v --pictures pictures"), ideal = report("--ideal circle --ends v");
    for (const char* key : {"iou", "band_agreement", "cut_iou", "holes", "wrong_cover", "not_finite", "base", "truth", "rendering", "band", "depth_mean", "depth_99",
                            "depth_max", "steps_mean", "steps_max", "milliseconds", "depth_scale", "views"})
        CHECK(bent.contains(key));
    CHECK(flat["band_agreement"] < 0.25); // deep reliefs end a march beyond the silhouette early
    CHECK(bent["band_agreement"] > 0.8);
    CHECK(bent["steps_mean"] > 1);
    CHECK(ideal["band_agreement"] > 0.85);
    CHECK(ideal["iou"] > flat["iou"]);
    CHECK(bent["iou"] > flat["iou"]);
    CHECK(bent["not_finite"] == 0);
    CHECK(bent["views"].size() == 1);
    CHECK(bent["views"][0]["angle"] == 90);
    for (const char* name : {"rendering", "truth", "difference"})
        CHECK(std::filesystem::exists(work_folder() / "pictures" / (std::string("mesh-90-020-") + name + ".png")));
    // The same for any number of threads.
    json one = report("--threads 1"), two = report("--threads 2");
    for (json* r : {&one, &two}) r->erase("milliseconds"), (*r)["views"][0].erase("milliseconds");
    CHECK(one == two);
    CHECK(run_tool("verify bumps.exr --mesh cylinder.glb --mesh-tiles 6,2 --size 200x150").out.find("in the band") != std::string::npos);
}

TEST_CASE("what is asked of the silhouette decides the exit code") {
    make_files();
    const std::string line = "verify bumps.exr --mesh cylinder.glb --depth-scale 0.1 --mesh-tiles 6,2 --size 200x150 --mesh-view 90,20 ";
    CHECK(run_tool(line + "--ideal circle --ends v --least-iou 0.97 --least-band 0.8").status == 0);
    const Outcome low = run_tool(line + "--correction none --least-band 0.8");
    CHECK(low.status == 4);
    CHECK(low.err.find("silhouette band") != std::string::npos);
    CHECK(run_tool(line + "--correction none --least-iou 0.99").status == 4);
}

TEST_CASE("what does not fit a mesh is refused in a line") {
    make_files();
    write_pgm(work_folder() / "spot.pgm", 16, 16, [](int x, int y) { return (x - 8) * (x - 8) + (y - 8) * (y - 8) < 20 ? 0 : 255; });
    REQUIRE(run_tool("shape spot.pgm -o spot.png --quiet").status == 0);
    const auto refused = [](const std::string& line, const std::string& part) {
        const Outcome outcome = run_tool(line);
        INFO(line << ": " << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find(part) != std::string::npos);
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') <= 2);
    };
    refused("verify bumps.exr --correction ray", "--mesh");
    refused("verify spot.png --mesh cylinder.glb --technique cone", "shape map");
    refused("verify spot.png --mesh cylinder.glb --correction cone-published", "cone maps");
    refused("verify bumps.exr --mesh cylinder.glb --ideal ab --steps 20", "--steps");
    refused("verify bumps.exr --mesh cylinder.glb --technique max-mip", "on meshes");
    refused("verify bumps.exr --mesh cylinder.glb --e 1", "--e");
    refused("verify bumps.exr --mesh cylinder.glb --mesh-view 10", "--mesh-view");
    refused("verify bumps.exr --mesh cylinder.glb --mesh-tiles 0", "--mesh-tiles");
    refused("verify bumps.exr --mesh cylinder.glb --size 10", "--size");
    refused("bench surface cylinder -o cylinder.obj", "quadrics");
    CHECK(run_tool("verify bumps.exr --mesh none.glb").status == 66);
    CHECK(run_tool("verify bumps.exr --mesh cylinder.glb --mesh-tiles 10000").status == 5);
}

TEST_CASE("render lays a map, or the extrusion of a shape, on meshes") {
    make_files();
    write_pgm(work_folder() / "disc.pgm", 32, 32, [](int x, int y) { return (x - 16) * (x - 16) + (y - 16) * (y - 16) < 90 ? 0 : 255; });
    REQUIRE(run_tool("shape disc.pgm -o disc.png --wrap repeat --quiet").status == 0);
    REQUIRE(run_tool("bench surface torus --segments 48 -o torus.ply").status == 0);
    const std::string view = " --size 120x90 --view 80 --depth-scale 0.1 ";
    const auto picture = [&](const std::string& line) {
        const Outcome outcome = run_tool("render " + line + view + "-o picture.png");
        INFO(line << ": " << outcome.err);
        REQUIRE(outcome.status == 0);
        return bytes_of((work_folder() / "picture.png").string());
    };
    const std::string one = picture("bumps.exr --mesh cylinder.glb --mesh-tiles 6,2 --ends v");
    CHECK(one == picture("bumps.exr --mesh cylinder.glb --mesh-tiles 6,2 --ends v"));
    for (const std::string other : {"--correction none", "--correction ray", "--mesh torus.ply", "--up y", "--technique binary --steps 40", "--steps 3"})
        CHECK(one != picture("bumps.exr --mesh cylinder.glb --mesh-tiles 6,2 --ends v " + other));
    const std::string basic = picture("disc.png --mesh torus.ply --mesh-tiles 8,3");
    for (const std::string other : {"--e 0.05", "--b 0.1", "--b 0.1 --c 0.5"}) CHECK(basic != picture("disc.png --mesh torus.ply --mesh-tiles 8,3 " + other));
}

TEST_CASE("render refuses what meshes do not take") {
    make_files();
    write_pgm(work_folder() / "disc.pgm", 8, 8, [](int x, int) { return x < 4 ? 0 : 255; });
    REQUIRE(run_tool("shape disc.pgm -o disc.png --quiet").status == 0);
    for (const std::string line :
         {"bumps.exr --mesh-tiles 2", "bumps.exr --mesh cylinder.glb --tiles 2", "bumps.exr --mesh cylinder.glb --e 0.1", "bumps.exr --mesh cylinder.glb --endless",
          "bumps.exr --mesh cylinder.glb --technique pom", "bumps.exr --mesh cylinder.glb --exact-finish", "bumps.exr --mesh cylinder.glb --shadow",
          "bumps.exr --mesh cylinder.glb --technique binary --correction cone", "disc.png --mesh cylinder.glb --correction cone", "disc.png --mesh cylinder.glb --technique cone",
          "disc.png --mesh cylinder.glb --solid revolution", "bumps.exr --mesh cylinder.glb --mesh-tiles 0", "bumps.exr --mesh cylinder.glb --ends w"}) {
        const Outcome outcome = run_tool("render " + line + " -o refused.png --size 64x48");
        CAPTURE(line, outcome.err);
        CHECK(outcome.status == 2);
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') <= 2);
        CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.png"));
    }
    CHECK(run_tool("render bumps.exr --mesh nowhere.glb -o refused.png").status == 66);
    std::ofstream(work_folder() / "bare.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    CHECK(run_tool("render bumps.exr --mesh bare.obj -o refused.png").err.find("reliefbake quadric") != std::string::npos);
}

// `verify`, `render` and `bench` from outside: what they refuse, and what they must not take for safe.

#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

void require_bake(const std::string& arguments) {
    const Outcome outcome = run_tool(arguments + " --quiet");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
}

constexpr const char* quick = " --rays 3000 --points 500 --crop 0";

json verified(const std::string& arguments, const char* effort = quick) {
    const Outcome outcome = run_tool("verify " + arguments + effort + " --json");
    INFO(outcome.err);
    REQUIRE(!outcome.out.empty());
    return json::parse(outcome.out);
}

} // namespace

TEST_CASE("render never overwrites its map, and writes what the name says") {
    require_bake("cone " + height_map("gz_dem_squared_129.tif") + " -o keep.exr");
    const std::string before = bytes_of(work_folder() / "keep.exr");
    CHECK(run_tool("render keep.exr -o keep.exr").status == 2);
    CHECK(run_tool("render keep.exr -o picture.jpg").status == 2);
    require_bake("cone " + height_map("gz_dem_squared_129.tif") + " -o keep.png --wrap clamp");
    const std::string png = bytes_of(work_folder() / "keep.png");
    CHECK(run_tool("render keep.png -o ./keep.png").status == 2);
    CHECK(run_tool("render keep.png -o picture.png --endless").status == 2);
    CHECK(bytes_of(work_folder() / "keep.exr") == before);
    CHECK(bytes_of(work_folder() / "keep.png") == png);
}

TEST_CASE("Absent channels are refused where they are needed, and never crash") {
    require_bake("cone " + height_map("gz_dem_squared_129.tif") + " -o absent.exr");
    CHECK(run_tool(std::string("verify absent.exr --channel-order=--BA") + quick).status == 0);
    const Outcome no_cones = run_tool(std::string("verify absent.exr --channel-order=---A") + quick);
    CHECK(no_cones.status == 0);
    CHECK(no_cones.out.find("cones: not checked") != std::string::npos);
    const Outcome no_depth = run_tool(std::string("verify absent.exr --channel-order=RGB-") + quick);
    CHECK(no_depth.status == 2);
    CHECK(no_depth.err.find("no depth channel") != std::string::npos);
    CHECK(run_tool("render absent.exr -o absent.png --channel-order=RGB- --size 16x16").status == 2);
}

TEST_CASE("A map is not called safe beside a height it was not baked from") {
    write_noise(work_folder() / "a.pgm", 32);
    write_pgm(work_folder() / "b.pgm", 32, 32, [](int x, int y) { return (x / 4 + y / 4) % 2 * 255; });
    require_bake("cone a.pgm -o a.png --bits 16");
    CHECK(run_tool(std::string("verify a.png --source a.pgm") + quick).status == 0);
    const Outcome other = run_tool(std::string("verify a.png --source b.pgm") + quick);
    CHECK(other.status == 4);
    CHECK(other.out.find("other_source") != std::string::npos);
    CHECK(run_tool(std::string("verify a.png --source a.pgm --input depth") + quick).status == 4);
    CHECK(run_tool("verify a.png --range 0:1").status == 2); // needs --source
}

TEST_CASE("8-bit filter weights: a one-texel wall is safe in every encoding") {
    write_pgm(work_folder() / "wall.pgm", 64, 48, [](int x, int) { return x == 31 ? 255 : 0; });
    for (const char* encoding : {"ratio", "sqrt", "radius", "normal"}) {
        CAPTURE(encoding);
        require_bake(std::string("cone wall.pgm -o wall.png --bits 8 --wrap clamp --encoding ") + encoding);
        const json report = verified("wall.png --filter fixed8", " --rays 60000 --points 500 --crop 0");
        CHECK(report["missed"] == 0);
        CHECK(report["verdict"] == "safe");
    }
}

TEST_CASE("render paints the error of a short march, and writes neither picture over a file it reads") {
    require_bake("cone " + height_map("gz_dem_squared_129.tif") + " -o error_map.exr");
    const std::string view = "render error_map.exr --size 48x32 --view 80 -o shaded.png --error ";
    const auto error_of = [&](const std::string& steps) {
        REQUIRE(run_tool(view + "error.png --steps " + steps).status == 0);
        return bytes_of(work_folder() / "error.png");
    };
    CHECK(error_of("500").size() < error_of("2").size()); // evenly dark
    CHECK(run_tool(view + "error.jpg").status == 2);
    CHECK(run_tool(view + "error_map.exr").status == 2);
    CHECK(run_tool(view + "./shaded.png").status == 2);
}

TEST_CASE("bench peer writes another method's map of the same surface, and verify finds what it misses") {
    require_bake("cone " + height_map("pom_rocks_NM_height.tga") + " --channel A --mips -o ours.exr");
    const auto peer = [](const std::string& method) {
        const Outcome outcome = run_tool("bench peer " + method + " ours.exr --level 3 --threads 1 -o " + method + ".exr --json");
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        CHECK(json::parse(outcome.out)["method"] == method);
        return verified(method + ".exr", " --rays 13000 --points 500 --crop 0");
    };
    CHECK(verified("ours.exr --level 3")["verdict"] == "safe");
    for (const char* method : {"brute-force", "expanding-ring", "quick-cone-map", "sampled-relaxed"}) {
        CAPTURE(method);
        const json report = peer(method);
        CHECK(report["missed"] > 0);
        CHECK(report["violations"] > 0);
    }
    // Brute force and the ring search find the same texel cones, to rounding.
    CHECK(verified("brute-force.exr")["steps_mean"] == Approx(double(verified("expanding-ring.exr")["steps_mean"])).epsilon(1e-3));
    const json facts = json::parse(run_tool("explain sampled-relaxed.exr --json").out);
    CHECK(facts["family"] == "relaxed");
    CHECK(facts["relaxed"] == "top");
    CHECK(facts["guarantee"] == "");
    CHECK(run_tool("bench peer sampled-relaxed ours.exr -o ours.exr").status == 2);
    CHECK(run_tool("bench peer sampled-relaxed ours.exr -o peer.jpg").status == 2);
    CHECK(run_tool("bench peer sampled ours.exr -o peer.exr").status == 2);
}

TEST_CASE("bench takes every instruction set it lists") {
    CHECK(run_tool("bench cone --field ramp --size 64 --simd scalar --repeat 1").status == 0);
    CHECK(run_tool("bench cone --field ramp --size 64 --simd automatic --repeat 1").status == 0);
    CHECK(run_tool("bench cone --field ramp --size 64 --simd mmx").status == 2);
}

TEST_CASE("Every family is baked, explained and verified; what does not fit is refused") {
    const std::string height = height_map("gz_dem_squared_129.tif");
    const struct {
        const char* bake;
        const char* family;
        const char* guarantee;
    } families[] = {
        {"cone --kind relaxed", "relaxed", "R"},
        {"cone --kind relaxed --relaxed slope:3", "relaxed", ""},
        {"cone --kind hybrid --delta 0.1", "hybrid", "R"},
        {"cone --lookup cell --encoding radius", "conservative", "C"},
        {"cone-normal", "conservative", "C"},
        {"acm --sectors 4 --metric l1", "conservative", "C"},
        {"acm --sectors 8 --kind relaxed", "relaxed", "R"},
        {"cone-stack --levels 3", "conservative", "C"},
        {"cone-stack --levels 3 --method 2", "conservative", "C"},
    };
    for (const auto& [bake, family, guarantee] : families) {
        CAPTURE(bake);
        require_bake(std::string(bake) + " " + height + " -o family.exr");
        const json facts = json::parse(run_tool("explain family.exr --json").out);
        CHECK(facts["family"] == family);
        CHECK(facts["guarantee"] == guarantee);
        const json report = verified("family.exr");
        CHECK(report["violations"] == 0);
        if (*guarantee) CHECK(report["missed"] == 0);
    }
    for (const char* bad : {"cone --relaxed strict", "cone --delta 0.1", "cone --kind hybrid", "cone --kind relaxed --surface texel",
                            "cone --lookup cell --surface texel", "acm --sectors 5", "acm --sectors 8 --metric l1", "acm --kind hybrid",
                            "cone --kind relaxed --relaxed slope:-1", "cone-stack --levels 0",
                            "cone-stack --method 3"}) {
        CAPTURE(bad);
        CHECK(run_tool(std::string(bad) + " " + height + " -o bad.exr").status == 2);
    }
    CHECK_FALSE(std::filesystem::exists(work_folder() / "bad.exr"));
}

TEST_CASE("Cones alone go with a relief map") {
    const std::string height = height_map("gz_dem_squared_129.tif");
    require_bake("acm " + height + " -o eight.png --sectors 8 --relief beside.png");
    CHECK(run_tool(std::string("verify eight.png") + quick).status != 0); // needs --relief
    CHECK(verified("eight.png --relief beside.png")["verdict"] == "safe");
    CHECK(verified("beside.png")["verdict"] == "safe");
    CHECK(run_tool("acm " + height + " -o eight.exr --sectors 8 --relief beside.png").status == 2); // named holds it itself
}

TEST_CASE("bench render counts the same work however many frames it times, and a shadow's march costs time") {
    require_bake("cone " + height_map("gz_dem_squared_129.tif") + " -o timed.exr --wrap repeat");
    const auto timed = [](const std::string& options) {
        const Outcome outcome = run_tool("bench render timed.exr --view 60 --endless --span 1 --size 64x48 " + options + " --json");
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        return json::parse(outcome.out);
    };
    const json once = timed("--frames 1 --technique linear --steps 10"), thrice = timed("--frames 3 --technique linear --steps 10");
    CHECK(once["rays"] == 64 * 48);
    CHECK(once["steps_mean"] == thrice["steps_mean"]);
    CHECK(once["steps_mean"] > 1);
    CHECK(once["steps_mean"] <= 10);
    CHECK(thrice["milliseconds_least"] <= thrice["milliseconds_median"]);
    CHECK(timed("--technique linear --steps 40")["steps_mean"] > 3 * once["steps_mean"].get<double>());
    CHECK(timed("--shadow hard --shadow-steps 20")["milliseconds_least"] > 0);
    for (const char* refused : {"--shadow-steps 20", "--shadow horizon", "--view 90", "--technique parallax --steps 3"})
        CHECK(run_tool(std::string("bench render timed.exr ") + refused).status == 2);
}

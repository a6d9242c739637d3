#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

std::string shape_picture(const std::string& name) { return std::string("'") + RELIEFBAKE_TEST_DATA + "/shapes/" + name + "'"; }

json bake(const std::string& arguments) {
    const Outcome outcome = run_tool("shape " + arguments + " --json");
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    const json result = json::parse(outcome.out);
    CHECK(outcome.err.empty() == result["warnings"].empty());
    return result;
}

json explain(const std::string& file) {
    const Outcome outcome = run_tool("explain --json " + file);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
}

/// A disc of dark texels, radius 9, in the middle of 40 x 30.
void write_disc(const std::string& name, int inside = 0, int outside = 255) {
    write_pgm(work_folder() / name, 40, 30, [&](int x, int y) { return (x - 20) * (x - 20) + (y - 15) * (y - 15) < 81 ? inside : outside; });
}

/// A 1-bit TIFF, 16 x 3, whose first row is 1100000000000000, the others 0. `photometric` 0: 0 is white.
void write_bit_tiff(const std::string& name, int photometric) {
    const auto word = [](int value) { return std::string{char(value & 255), char(value >> 8)}; };
    const auto longer = [&](int value) { return word(value & 0xffff) + word(value >> 16); };
    const auto entry = [&](int tag, int type, int value) { return word(tag) + word(type) + longer(1) + longer(value); };
    std::string file = std::string("II") + word(42) + longer(8) + word(8);
    file += entry(256, 4, 16) + entry(257, 4, 3) + entry(258, 3, 1) + entry(259, 3, 1) + entry(262, 3, photometric);
    const int pixels = 8 + 2 + 8 * 12 + 4;
    file += entry(273, 4, pixels) + entry(278, 4, 3) + entry(279, 4, 6) + longer(0);
    file += std::string("\xc0\0\0\0\0\0", 6);
    std::ofstream(work_folder() / name, std::ios::binary) << file;
}

} // namespace

TEST_CASE("Every bit depth of every format of a shape map says what it is and verifies") {
    const char* outputs[][2] = {{"png", "8"},    {"png", "16"},    {"tif", "8"},    {"tif", "16"},
                                {"tif", "half"}, {"tif", "float"}, {"exr", "half"}, {"exr", "float"}};
    for (const auto& [extension, bits] : outputs)
        for (const std::string options : {"", " --signed --wrap repeat", " --antialiased --invert", " --model centres --scale-f 0.4"}) {
            const std::string file = std::string("shape.") + extension;
            const json result = bake(shape_picture("flipper128.png") + " -o " + file + " --bits " + bits + options);
            const json map = explain(file);
            INFO(file << " " << bits << options);
            CHECK(map == result["map"]);
            CHECK(map["kind"] == "shape");
            CHECK(map["guarantee"] == "S");
            CHECK((map["bits"].is_string() ? map["bits"].get<std::string>() : map["bits"].dump()) == bits);
            CHECK(map["tau"].get<double>() == Approx(map["scale_f"].get<double>() * map["max_distance"].get<double>() / 128).epsilon(1e-6));
            if (options != " --antialiased --invert") continue; // tests/shapes_all.sh follows rays for all of them
            const Outcome verified = run_tool("verify " + file + " --points 3000 --rays 3000 --json");
            INFO(verified.err);
            CHECK(verified.status == 0);
            CHECK(json::parse(verified.out)["violations"] == 0);
        }
}

TEST_CASE("The result object of shape is what its schema says") {
    const json result = bake(shape_picture("kenney_wrench_alpha.png") + " -o wrench.png");
    const json schema = json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/shape.schema.json"));
    CHECK(schema_fault(result, schema) == "");
    json broken = result;
    broken["inside"] = "grey";
    CHECK(schema_fault(broken, schema) == "$.inside: not one of the words");
}

TEST_CASE("What is opaque in an alpha is the shape, what is dark elsewhere, and --invert takes the other side") {
    const auto inside = [&](const std::string& arguments) { return bake(arguments)["map"]["statistics"]["inside_texels"].get<int>(); };
    const std::string wrench = shape_picture("kenney_wrench_alpha.png"); // a palette with transparency
    const json result = bake(wrench + " -o wrench.png");
    CHECK(result["source"]["channel"] == "A");
    CHECK(result["inside"] == "bright");
    CHECK(result["map"]["statistics"]["inside_texels"] == 1918);
    CHECK(inside(wrench + " -o wrench.png --invert") == 10000 - 1918);
    CHECK(inside(wrench + " -o wrench.png --channel A --threshold 0.9") < 1918);
    write_disc("disc.pgm");
    const int disc = inside("disc.pgm -o disc.png");
    CHECK(bake("disc.pgm -o disc.png")["inside"] == "dark");
    CHECK(disc > 220);
    CHECK(inside("disc.pgm -o disc.png --invert") == 1200 - disc);
    CHECK(explain("disc.png")["inverted"] == true);
}

TEST_CASE("1-bit TIFFs are shapes, whichever of their bits is white") {
    write_bit_tiff("black.tif", 1);
    write_bit_tiff("white.tif", 0);
    CHECK(bake("black.tif -o bits.png --invert")["map"]["statistics"]["inside_texels"] == 2);
    CHECK(bake("white.tif -o bits.png")["map"]["statistics"]["inside_texels"] == 2);
}

TEST_CASE("A tile's distances reach across its border") {
    write_pgm(work_folder() / "edge.pgm", 64, 8, [](int x, int) { return x == 0 ? 0 : 255; });
    CHECK(bake("edge.pgm -o edge.png --model centres")["map"]["max_distance"] == 63);
    CHECK(bake("edge.pgm -o edge.png --model centres --wrap repeat")["map"]["max_distance"] == 32);
    CHECK(bake("edge.pgm -o edge.png --model centres --wrap clamp,repeat")["map"]["max_distance"] == 63);
    CHECK(explain("edge.png")["wrap"] == json({"clamp", "repeat"}));
}

TEST_CASE("Empty and full shapes are baked, and warned about") {
    write_disc("empty.pgm", 255, 255);
    write_disc("full.pgm", 0, 0);
    const json empty = bake("empty.pgm -o empty.png");
    CHECK(empty["map"]["max_distance"] == 50);
    CHECK(empty["warnings"][0].get<std::string>().find("no texel is inside") != std::string::npos);
    CHECK(run_tool("verify empty.png --points 1000 --rays 1000").status == 0);
    const json full = bake("full.pgm -o full.png");
    CHECK(full["map"]["max_distance"] == 0);
    CHECK(full["warnings"][0].get<std::string>().find("every texel is inside") != std::string::npos);
    CHECK(run_tool("verify full.png --points 1000 --rays 1000").status == 0);
}

TEST_CASE("Coarse codes are warned about") {
    write_pgm(work_folder() / "far.pgm", 600, 8, [](int x, int) { return x == 0 ? 0 : 255; });
    CHECK(bake("far.pgm -o far.png --bits 8")["warnings"][0].get<std::string>().find("--bits 16") != std::string::npos);
    CHECK(bake("far.pgm -o far.png --bits 16")["warnings"].empty());
    CHECK(bake("far.pgm -o far.png --bits 8 --scale-f 0.4")["warnings"].empty());
}

TEST_CASE("Distances that filtering eats up are warned about") {
    write_disc("disc.pgm");
    CHECK(bake("disc.pgm -o short.exr")["warnings"].empty());
    CHECK(bake("disc.pgm -o short.exr --scale-f 0.03")["warnings"][0].get<std::string>().find("larger --scale-f") != std::string::npos);
    write_pgm(work_folder() / "stripes.pgm", 24, 24, [](int x, int) { return x % 2 ? 0 : 255; });
    CHECK(bake("stripes.pgm -o short.exr")["warnings"][0].get<std::string>().find("larger picture") != std::string::npos);
}

TEST_CASE("An anti-aliased shape of faint texels is not called empty, nor one of strong ones full") {
    write_pgm(work_folder() / "faint.pgm", 24, 24, [](int x, int) { return x == 12 ? 200 : 255; });
    CHECK(bake("faint.pgm -o faint.exr --antialiased")["warnings"].empty());
    CHECK(bake("faint.pgm -o faint.exr")["warnings"][0].get<std::string>().find("no texel is inside") != std::string::npos);
    write_pgm(work_folder() / "strong.pgm", 24, 24, [](int x, int) { return x == 12 ? 100 : 0; });
    for (const json& warning : bake("strong.pgm -o strong.exr --antialiased")["warnings"]) CHECK(warning.get<std::string>().find("every texel") == std::string::npos);
}

TEST_CASE("Danielsson's method says how wrong it is and promises nothing") {
    const json map = bake(shape_picture("flipper128.png") + " -o d.png --method danielsson")["map"];
    CHECK(map["method"] == "danielsson");
    CHECK(map["model"] == "centres");
    CHECK(map["guarantee"] == "");
    CHECK(map["statistics"].contains("error_max"));
    CHECK(map["statistics"].contains("wrong_texels"));
}

TEST_CASE("The same shape has the same bytes for every number of threads and in other locales") {
    const std::string arguments = "shape " + shape_picture("flipper128.png") + " --antialiased --signed -o ";
    REQUIRE(run_tool(arguments + "one.exr --threads 1").status == 0);
    REQUIRE(run_tool(arguments + "three.exr --threads 3", "LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo").status == 0);
    CHECK(bytes_of(work_folder() / "one.exr") == bytes_of(work_folder() / "three.exr"));
}

TEST_CASE("shape refuses what it cannot do, and leaves nothing behind") {
    write_disc("disc.pgm");
    write_pfm(work_folder() / "large.pfm", 4, 4, [](int x, int) { return float(x); });
    const struct {
        const char* arguments;
        int status;
        const char* names; ///< what stderr must contain
    } refusals[] = {
        {"disc.pgm -o refused.png --threshold 1.5", 2, "0 to 1"},
        {"disc.pgm -o refused.png --scale-f 0", 2, "above 0"},
        {"disc.pgm -o refused.png --scale-f 1.5", 2, "at most 1"},
        {"disc.pgm -o refused.png --model contour", 2, "squares|centres"},
        {"disc.pgm -o refused.png --model centres --antialiased", 2, "--model"},
        {"disc.pgm -o refused.png --antialiased --threshold 0.4", 2, "--threshold"},
        {"disc.pgm -o refused.png --method danielsson --model squares", 2, "--model centres"},
        {"disc.pgm -o refused.png --method danielsson --antialiased", 2, "--model centres"},
        {"disc.pgm -o refused.png --method danielsson --wrap repeat", 2, "--wrap"},
        {"disc.pgm -o refused.png --wrap mirror", 2, "repeat|clamp"},
        {"disc.pgm -o refused.png --bits half", 2, "8 or 16 bits"},
        {"disc.pgm -o refused.exr --bits 8", 2, "half or float"},
        {"disc.pgm -o refused.png --exr-layout named", 2, "--exr-layout"},
        {"disc.pgm -o refused.jpg", 2, ".png"},
        {"disc.pgm -o disc.pgm", 2, "input file"},
        {"disc.pgm -o no/such/folder/refused.png", 73, "no/such/folder"},
        {"disc.pgm -o refused.png --json --quiet", 2, "--quiet"},
        {"disc.pgm -o refused.png --channel A", 65, "no channel A"},
        {"large.pfm -o refused.png --antialiased", 65, "0..1"},
        {"none.pgm -o refused.png", 66, "none.pgm"},
    };
    for (const auto& [arguments, status, names] : refusals) {
        INFO(arguments);
        const Outcome outcome = run_tool(std::string("shape ") + arguments);
        CHECK(outcome.status == status);
        INFO(outcome.err);
        CHECK(outcome.err.find(names) != std::string::npos);
        CHECK(outcome.out.empty());
        CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.png"));
        CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.exr"));
    }
}

TEST_CASE("bench shape times pictures and agrees with the textbook's transform") {
    const Outcome outcome = run_tool("bench shape --size 200 --repeat 1 --plain --json");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const json result = json::parse(outcome.out);
    CHECK(result["results"].size() == 5);
    for (const json& picture : result["results"]) {
        CHECK(picture["ns_per_pixel"].get<double>() > 0);
        CHECK(picture["peers"][0]["wrong"] == 0.0);
    }
    CHECK(run_tool("bench shape --size 200 --to squares --plain").status == 2);
}

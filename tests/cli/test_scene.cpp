// reliefbake scene, from outside.

#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

const std::string courtyard = "'" RELIEFBAKE_TEST_DATA "/scene/courtyard.toml'";

json parsed(const Outcome& outcome) {
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const json result = json::parse(outcome.out, nullptr, false);
    REQUIRE_FALSE(result.is_discarded());
    static const json schema = json::parse(bytes_of(RELIEFBAKE_SCHEMA_DIR "/scene.schema.json"));
    CHECK(schema_fault(result, schema) == "");
    return result;
}

std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> names;
    if (fs::exists(folder))
        for (const auto& entry : fs::recursive_directory_iterator(folder)) names.insert(fs::relative(entry.path(), folder).string());
    return names;
}

std::set<std::string> files_listed(const json& result) {
    std::set<std::string> names;
    for (const json& run : result["runs"])
        for (const json& map : run["maps"])
            for (const json& file : map["files"]) CHECK(names.insert(file["name"].get<std::string>()).second);
    return names;
}

void write_text(const std::string& name, const std::string& text) {
    fs::create_directories((work_folder() / name).parent_path());
    std::ofstream(work_folder() / name, std::ios::binary) << text;
}

/// A source of 16 x 12 texels.
void write_height(const std::string& name) {
    fs::create_directories((work_folder() / name).parent_path());
    write_pgm(work_folder() / name, 16, 12, [](int x, int y) { return (x * 37 + y * 91) % 256; });
}

json asset_named(const json& result, const std::string& name) {
    for (const json& asset : result["assets"])
        if (asset["name"] == name) return asset;
    FAIL("no asset " + name);
    return {};
}

std::string asset(const std::string& name, const std::string& keys) { return "[[asset]]\nname = \"" + name + "\"\n" + keys + "\n"; }

} // namespace

TEST_CASE("the example scene is baked as it was announced, and holds what its maps promise") {
    const json planned = parsed(run_tool("scene " + courtyard + " -o yard --dry-run --json"));
    CHECK_FALSE(fs::exists(work_folder() / "yard"));
    CHECK(planned["dry_run"] == true);
    const Outcome outcome = run_tool("scene " + courtyard + " -o yard --json");
    for (std::istringstream lines(outcome.err); lines;) { // a source is tagged sRGB
        std::string line;
        if (std::getline(lines, line)) CHECK(line.find("warning: ") != std::string::npos);
    }
    const json baked = parsed(outcome);
    CHECK(files_listed(planned) == files_listed(baked));
    CHECK(files_in(work_folder() / "yard") == files_listed(baked));
    CHECK(planned["bytes"] == baked["bytes"]);
    CHECK(planned["assets"] == baked["assets"]);
    CHECK(baked["bytes"].get<double>() < 0.2 * baked["everything"]["bytes"].get<double>());
    CHECK(baked["saved_bytes"].get<double>() == baked["everything"]["bytes"].get<double>() - baked["bytes"].get<double>());

    // What was shared, chosen and left out.
    CHECK(asset_named(baked, "meadow")["needed"] == false);
    CHECK(asset_named(baked, "meadow")["left_out"].get<std::string>().find("not baked") != std::string::npos);
    CHECK(asset_named(baked, "roof far away")["maps"] == json::array({{{"map", "roof tiles.png"}, {"as", "relief"}}}));
    CHECK(asset_named(baked, "dolphin turned")["maps"][0]["map"] == "dolphin.png");
    CHECK(asset_named(baked, "roof tiles")["level"] == 1);
    CHECK(asset_named(baked, "cobblestones")["bits"] == "8");
    CHECK(asset_named(baked, "cobblestones")["choice"].get<std::string>().find("loss below 16 bits") != std::string::npos);
    CHECK(asset_named(baked, "dunes")["choice"].get<std::string>().find("measured") != std::string::npos);

    // The files are what the plan says of them, and hold.
    std::map<std::string, std::string> reliefs = {{"dunes.png", " --relief 'yard/dunes_relief.png'"}, {"carved panel_horizon.png", " --relief yard/column.png"}};
    for (const json& run : baked["runs"])
        for (const json& map : run["maps"]) {
            const std::string name = map["output"].get<std::string>(), command = map["command"].get<std::string>();
            const std::string file = "'yard/" + name + "'";
            CAPTURE(name);
            if (command == "quadric") {
                CHECK(run_tool("render yard/column.png --mesh " + file + " -o picture.png --size 64x48").status == 0);
                continue;
            }
            const json told = json::parse(run_tool("explain " + file + " --json").out, nullptr, false);
            CHECK(told["width"] == map["files"][0]["width"].get<int>() / (name == "dunes.png" && map["what"] == "8 sectors" ? 2 : 1));
            if (name == "carved panel_horizon.png") continue; // wants a relief of its own bits
            const bool march = command != "bump" && command != "shape";
            const Outcome judged = run_tool("verify " + file + reliefs[name] + (march ? " --rays 13000 --points 1000 --crop 0" : command == "shape" ? " --rays 13000" : ""));
            CAPTURE(judged.out, judged.err);
            CHECK(judged.status == 0);
        }
}

TEST_CASE("the same bytes for any number of threads") {
    for (const std::string threads : {"1", "3"}) REQUIRE(run_tool("scene " + courtyard + " --quiet -o same" + threads + " --threads " + threads).status == 0);
    const std::set<std::string> files = files_in(work_folder() / "same1");
    CHECK(files == files_in(work_folder() / "same3"));
    for (const std::string& file : files) {
        CAPTURE(file);
        CHECK(bytes_of(work_folder() / "same1" / file) == bytes_of(work_folder() / "same3" / file));
    }
}

TEST_CASE("paths and names with blanks and quotes") {
    write_height("odd 'folder'/a \"b\" (1).pgm");
    write_text("odd 'folder'/s.toml", asset("it's 1", "height = 'a \"b\" (1).pgm'\ntechnique = \"relaxed\"\nfeatures = [\"ao\", \"mips\"]"));
    const json result = parsed(run_tool("scene \"odd 'folder'/s.toml\" -o \"out 'x'\" --json"));
    CHECK(files_in(work_folder() / "out 'x'") == files_listed(result));
    CHECK(files_listed(result).count("it's 1_ambient_mip4.png") == 1);
    CHECK(result["runs"].size() == 1); // both in one run
    REQUIRE(run_tool("scene \"odd 'folder'/s.toml\" -o ./-x --quiet").status == 0);
}

TEST_CASE("what cannot be baked is refused before anything is written") {
    write_height("in/h.pgm");
    write_height("in/g.pgm");
    const auto refused = [](const std::string& text, int status, const std::string& words, const std::string& folder = "none") {
        write_text("in/s.toml", text);
        const std::set<std::string> before = files_in(work_folder() / "in");
        const Outcome outcome = run_tool("scene in/s.toml -o " + folder);
        CAPTURE(text, outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.err.find(words) != std::string::npos);
        CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
        CHECK(outcome.out == "");
        CHECK_FALSE(fs::exists(work_folder() / "none"));
        CHECK(files_in(work_folder() / "in") == before);
    };
    const std::string cone = "height = \"h.pgm\"\ntechnique = \"cone\"\n";
    refused(asset("a", cone + "angle = 60.0"), 2, "angle: needs");
    refused(asset("a", cone) + asset("b", "height = \"absent.png\"\ntechnique = \"cone\""), 66, "absent.png");
    refused(asset("a", cone) + asset("b", "height = \"absent.png\""), 66, "absent.png"); // also where nothing is baked from it
    refused(asset("a", cone) + asset("b", cone + "channel = \"Q\""), 65, "h.pgm");
    refused(asset("a", cone) + asset("b", cone + "wrap = \"around\""), 2, "around");
    refused(asset("a", cone) + asset("A", cone), 2, "two assets");
    refused(asset("a", "height = \"h.pgm\"\ntechnique = \"bump\"\nfeatures = [\"shadow\"]") + asset("a_HORIZON", "height = \"g.pgm\"\ntechnique = \"cone\""), 2, "a_horizon");
    refused(asset("a_horizon", "height = \"h.pgm\"\ntechnique = \"bump\"\nfeatures = [\"shadow\"]") + asset("a_horizon_horizon_b", "height = \"g.pgm\"\ntechnique = \"cone\""), 2, "_horizon_b");
    refused(asset("a", "height = \"h.pgm\"\ntechnique = \"sectors\"\nsectors = 4") + asset("a_relief", "height = \"g.pgm\"\ntechnique = \"cone\""), 2, "a_relief.png");
    refused(asset("a", cone + "features = [\"mips\"]") + asset("a_mip2", "height = \"g.pgm\"\ntechnique = \"cone\""), 2, "a_mip2.png");
    refused(asset("a", "height = \"h.pgm\"\ntechnique = \"relaxed\"\nfeatures = [\"ao\"]") + asset("a_ambient", "height = \"g.pgm\"\ntechnique = \"cone\""), 2, "a_ambient.png");
    refused(asset("a", cone + "max_error = 1e-9"), 5, "max_error");
    refused(asset("a", cone + "max_wrong = 0.0\nsteps = 1\nangle = 80.0"), 5, "max_wrong");
    refused(asset("a", cone), 73, "no folder", "in/h.pgm");
    refused("[[asset]]\nname = 1\n", 2, "expected text");
    refused("", 2, "found none");
    refused("colour = 1\n", 65, "colour");
    refused("format = \"exr\"\n" + asset("a", cone), 65, "png or tif");
    refused("a = " + std::string(5000, '['), 65, "s.toml");
    refused("[[asset]\n", 65, "s.toml:1");

    // An input of any asset, baked or not, is never written over.
    fs::rename(work_folder() / "in/h.pgm", work_folder() / "in/h.png");
    fs::rename(work_folder() / "in/g.pgm", work_folder() / "in/g.png");
    refused(asset("g", "height = \"h.png\"\ntechnique = \"cone\"") + asset("idle", "height = \"g.png\""), 2, "is an input", "in");
    fs::create_symlink("in", work_folder() / "link");
    refused(asset("G", "height = \"h.png\"\ntechnique = \"cone\"") + asset("idle", "height = \"g.png\""), 2, "is an input", "link");
    CHECK(run_tool("scene absent.toml -o none").status == 66);
    CHECK(run_tool("scene in/h.png -o none").status == 2);
    CHECK_FALSE(fs::exists(work_folder() / "none"));
}

TEST_CASE("a glTF names its maps in its materials' extras") {
    write_height("asset/maps/stone wall.pgm");
    write_height("secret.pgm");
    const auto document = [](const std::string& uri, const std::string& more = "") {
        return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
 "materials": [
  {"name": "old wall", "extras": {"reliefbake": {"height": ")" + uri + R"(", "technique": "curved", "features": ["silhouette"])" + more + R"(}}},
  {"name": "unworn", "extras": {"reliefbake": {"height": "maps/stone%20wall.pgm", "technique": "cone"}}},
  {"name": "plain"}],
 "buffers": [{"byteLength": 42, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}, {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}]})";
    };
    write_text("asset/wall.gltf", document("maps/stone%20wall.pgm"));
    const json result = parsed(run_tool("scene asset/wall.gltf -o walls --json"));
    CHECK(files_in(work_folder() / "walls") == std::set<std::string>{"old wall.png", "old wall_quadrics.glb"});
    CHECK(asset_named(result, "unworn")["left_out"].get<std::string>().find("no primitive") != std::string::npos);
    CHECK(result["assets"].size() == 2);

    fs::create_symlink("../../secret.pgm", work_folder() / "asset/maps/link.pgm");
    for (const std::string uri : {"../secret.pgm", "maps/../../secret.pgm", "%2e%2e/secret.pgm", "maps/link.pgm", "/etc/passwd", "file:///etc/passwd", "..\\\\secret.pgm", "maps/%zz"}) {
        write_text("asset/bad.gltf", document(uri));
        const Outcome outcome = run_tool("scene asset/bad.gltf -o none");
        CAPTURE(uri, outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find("asset 'old wall'") != std::string::npos);
        CHECK_FALSE(fs::exists(work_folder() / "none"));
    }
    write_text("asset/bad.gltf", document("maps/stone%20wall.pgm", R"(, "glow": 1)"));
    CHECK(run_tool("scene asset/bad.gltf -o none").err.find("unknown key 'glow'") != std::string::npos);
    write_text("asset/bad.gltf", std::string(100000, '['));
    CHECK(run_tool("scene asset/bad.gltf -o none").status == 65);
}

TEST_CASE("bench scene times a scene's maps beside everything") {
    write_height("tiny.pgm");
    write_text("tiny.toml", asset("a", "height = \"tiny.pgm\"\ntechnique = \"parallax\""));
    const Outcome outcome = run_tool("bench scene tiny.toml -o timed --threads 1");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(files_in(work_folder() / "timed/needed") == std::set<std::string>{"a.png"});
    CHECK(files_in(work_folder() / "timed/everything").size() > 10);
    CHECK(outcome.out.find("relaxed cones") != std::string::npos);
    CHECK(outcome.out.find("everything ") != std::string::npos);
}

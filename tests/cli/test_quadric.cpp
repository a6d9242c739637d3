#include "tests/cli/json_schema.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <string>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

/// A bent sheet of 3 x 3 vertices, its texture along x and y.
void write_sheet(const std::string& name) {
    std::ofstream out(work_folder() / name);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) out << "v " << i << " " << j << " " << 0.1 * i * j << "\nvt " << i / 2.0 << " " << j / 2.0 << "\n";
    for (const int k : {1, 2, 4, 5})
        out << "f " << k << "/" << k << " " << k + 1 << "/" << k + 1 << " " << k + 4 << "/" << k + 4 << " " << k + 3 << "/" << k + 3 << "\n";
}

json schema() { return json::parse(bytes_of(std::filesystem::path(RELIEFBAKE_SCHEMA_DIR) / "quadric.schema.json")); }

} // namespace

TEST_CASE("quadric: every output and option gives a file and an object of the schema") {
    write_sheet("sheet.obj");
    for (const std::string output : {"sheet.glb", "sheet.gltf", "sheet.ply"})
        for (const std::string options : {"", "--terms ab", "--fit paper", "--frame principal", "--frame uv", "--store color"}) {
            const Outcome outcome = run_tool("quadric sheet.obj -o " + output + " " + options + " --json");
            INFO(output << " " << options << "\n" << outcome.err);
            REQUIRE(outcome.status == 0);
            const json result = json::parse(outcome.out);
            CHECK(schema_fault(result, schema()) == "");
            CHECK(result["counts"]["vertices"] == 9);
            CHECK(result["counts"]["boundary"] == 8);
            CHECK(outcome.err.empty() == result["warnings"].empty());
            CHECK(result["quadric"]["terms"].size() == (options == "--terms ab" || options == "--fit paper" ? 2 : 3));
            CHECK(std::filesystem::file_size(work_folder() / output) > 500);
        }
}

TEST_CASE("quadric: the two-term fit says when frames are turned off the principal directions") {
    write_sheet("sheet.obj"); // z = x y / 10: all of its curvature is c
    const Outcome turned = run_tool("quadric sheet.obj -o sheet.ply --fit paper");
    CHECK(turned.status == 0);
    CHECK(turned.err.find("leaves out c") != std::string::npos);
    CHECK(turned.err.find("--fit ring") != std::string::npos);
    const Outcome aligned = run_tool("quadric sheet.obj -o sheet.ply --fit paper --frame principal");
    CHECK(aligned.err.find("leaves out c") == std::string::npos);
    CHECK(aligned.err.find("do not follow the texture") != std::string::npos);
}

TEST_CASE("quadric: same bytes for every number of threads and every locale") {
    write_sheet("sheet.obj");
    for (const std::string output : {"a.glb", "a.ply"}) {
        REQUIRE(run_tool("quadric sheet.obj --quiet --threads 1 -o " + output).status == 0);
        const std::string first = bytes_of(work_folder() / output);
        REQUIRE(run_tool("quadric sheet.obj --quiet --threads 3 -o " + output, "LC_ALL=de_DE.UTF-8").status == 0);
        CHECK(bytes_of(work_folder() / output) == first);
    }
}

TEST_CASE("quadric: a preview is a picture of two panels") {
    write_sheet("sheet.obj");
    REQUIRE(run_tool("quadric sheet.obj -o sheet.ply --quiet --preview sheet.png").status == 0);
    const std::string bytes = bytes_of(work_folder() / "sheet.png");
    REQUIRE(bytes.size() > 2000);
    const auto number = [&](std::size_t at) { return (unsigned char)bytes[at] << 8 | (unsigned char)bytes[at + 1]; };
    CHECK(number(18) == 1200);
    CHECK(number(22) == 600);
}

TEST_CASE("quadric: what cannot be is refused in one line and leaves no file") {
    write_sheet("sheet.obj");
    { std::ofstream(work_folder() / "points.obj") << "v 0 0 0\n"; }
    { std::ofstream(work_folder() / "broken.glb") << "glTF and nothing else"; }
    const struct {
        const char* arguments;
        int status;
        const char* names;
    } refusals[] = {
        {"sheet.obj -o refused.obj", 2, "write .glb, .gltf or .ply"},
        {"sheet.obj -o refused.dat", 2, ".glb, .gltf or .ply"},
        {"sheet.obj -o refused.ply --store uv:1", 2, "PLY has no numbered texture coordinates"},
        {"sheet.obj -o refused.glb --store uv:9", 2, "uv:0 to uv:7"},
        {"sheet.obj -o refused.glb --store uv:0", 2, "TEXCOORD_0"},
        {"sheet.obj -o refused.glb --frame mesh", 2, "--frame mesh"},
        {"sheet.obj -o refused.glb --frame flat", 2, "uv|mesh|principal"},
        {"sheet.obj -o refused.glb --fit best", 2, "expected"},
        {"sheet.obj -o sheet.obj", 2, "input file"},
        {"sheet.obj -o refused.glb --preview refused.jpg", 2, "--preview"},
        {"sheet.obj -o refused.glb --preview nowhere/p.png", 73, "nowhere"},
        {"points.obj -o refused.glb", 65, "no faces"},
        {"broken.glb -o refused.glb", 65, "broken.glb"},
        {"absent.obj -o refused.glb", 66, "absent.obj"},
        {"sheet.obj -o nowhere/refused.glb", 73, "nowhere"},
        {"sheet.obj -o refused.glb --max-bytes 100", 65, "--max-bytes"},
    };
    for (const auto& refusal : refusals) {
        INFO(refusal.arguments);
        const Outcome outcome = run_tool(std::string("quadric ") + refusal.arguments);
        CHECK(outcome.status == refusal.status);
        CHECK(outcome.err.find(refusal.names) != std::string::npos);
        CHECK(outcome.out.empty());
        CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.glb"));
        CHECK_FALSE(std::filesystem::exists(work_folder() / "refused.ply"));
    }
}

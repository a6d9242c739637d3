// -MF, -MT, --if-changed: what a build needs to know of a bake.

#include "tests/cli/batch_folder.h"

#include <filesystem>
#include <fstream>

using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {

fs::path place(const char* name) { return work_folder() / name; }

} // namespace

TEST_CASE("A depfile names the output and all that was read, as make wants names") {
    fs::remove_all(place("my src"));
    write_height(place("my src") / "a #1 $x.pgm", 1);
    write_height(place("my src") / "mask.pgm", 2);
    REQUIRE(run_tool("cone 'my src/a #1 $x.pgm' -o out.exr --quiet --alpha 'my src/mask.pgm' -MF deps.d").status == 0);
    CHECK(bytes_of(place("deps.d")) == "out.exr: my\\ src/a\\ \\#1\\ $$x.pgm my\\ src/mask.pgm\n");
    REQUIRE(run_tool("cone 'my src/mask.pgm' -o out.exr --quiet --depfile deps.d --depfile-target 'the stamp'").status == 0);
    CHECK(bytes_of(place("deps.d")) == "the\\ stamp: my\\ src/mask.pgm\n");
    write_text(place("m.obj"), pyramid_mesh);
    REQUIRE(run_tool("quadric m.obj -o m.glb --quiet -MF deps.d -MT m").status == 0);
    CHECK(bytes_of(place("deps.d")) == "m: m.obj\n");
}

TEST_CASE("No depfile after a bake that failed, none that replaces a file of the bake, none without a bake") {
    write_height(place("a.pgm"), 1);
    fs::remove(place("none.d"));
    CHECK(run_tool("cone missing.pgm -o out.exr --quiet -MF none.d").status == 66);
    CHECK_FALSE(fs::exists(place("none.d")));
    const std::string before = bytes_of(place("a.pgm"));
    CHECK(run_tool("cone a.pgm -o out.exr --quiet -MF a.pgm").status == 2);
    CHECK(run_tool("cone a.pgm -o out.exr --quiet -MF ./out.exr").status == 2);
    CHECK(bytes_of(place("a.pgm")) == before);
    CHECK(run_tool("cone a.pgm -o out.exr --quiet -MT target").status == 2);
    CHECK(run_tool("explain out.exr -MF none.d").status == 2);
}

TEST_CASE("--if-changed leaves a file of equal bytes with its time, and replaces any other") {
    for (const char* output : {"kept.png", "kept.exr", "kept.ktx2"}) {
        CAPTURE(output);
        const std::string to = std::string(" -o ") + output + " --quiet ";
        write_height(place("b.pgm"), 1);
        REQUIRE(run_tool("cone b.pgm" + to).status == 0);
        const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(5);
        fs::last_write_time(place(output), long_ago);
        REQUIRE(run_tool("cone b.pgm --if-changed" + to).status == 0);
        CHECK(fs::last_write_time(place(output)) == long_ago);
        REQUIRE(run_tool("cone b.pgm" + to).status == 0);
        CHECK(fs::last_write_time(place(output)) > long_ago);
        fs::last_write_time(place(output), long_ago);
        write_height(place("b.pgm"), 2);
        REQUIRE(run_tool("cone b.pgm --if-changed" + to).status == 0);
        CHECK(fs::last_write_time(place(output)) > long_ago);
        // As long as before, other bytes.
        std::string edited = bytes_of(place(output));
        const std::string right = edited;
        edited.back() ^= 1;
        write_text(place(output), edited);
        REQUIRE(run_tool("cone b.pgm --if-changed" + to).status == 0);
        CHECK(bytes_of(place(output)) == right);
    }
}

// Out of core, every disk that fails: strace injects the fault, and each test sees that it did.

#include "tests/cli/run_tool.h"
#include "tests/cli/running_tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <tuple>

using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {

int count_strays() {
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(work_folder())) count += entry.path().filename().string().starts_with(".reliefbake-");
    return count;
}

} // namespace

TEST_CASE("Every disk that fails leaves the previous file, one line and nothing else") {
    REQUIRE(run_tool("bench terrain -o tiles.tif --width 301 --height 517").status == 0);
    const std::string previous = "what was here before", folder = "cd '" + work_folder().string() + "' && ";
    const auto traced = [&](const std::string& inject, const std::string& arguments) {
        std::ofstream(work_folder() / "map.exr") << previous;
        std::ofstream(work_folder() / "map.band") << previous;
        return shell_status(std::system((folder + "ASAN_OPTIONS=detect_leaks=0 strace -f -y -o trace -e trace=fallocate,pwrite64,fsync,/^rename " + inject + " '" +
                                         RELIEFBAKE_BINARY + "' " + arguments + " --quiet 2>stderr").c_str()));
    };
    const std::string whole = "cone tiles.tif -o map.exr --out-of-core", band = "cone tiles.tif -o map.band --rows 0:64";
    traced("", whole);
    if (bytes_of(work_folder() / "trace").find("fsync") == std::string::npos) {
        WARN("SKIPPED: strace is missing or may not trace here: faults of the disk are not tested");
        return;
    }
    REQUIRE(run_tool("cone tiles.tif -o a.band --rows 0:320 --bits half --quiet").status == 0);
    REQUIRE(run_tool("cone tiles.tif -o b.band --rows 320:517 --bits half --quiet").status == 0);
    const std::string merge = "merge a.band b.band -o map.exr";
    const std::tuple<std::string, std::string, std::string> faults[] = {
        {whole, "fallocate:error=ENOSPC", "map.exr"},        // working space for the heights
        {whole, "pwrite64:error=ENOSPC:when=1", "map.exr"},  // baked rows
        {whole, "pwrite64:error=ENOSPC:when=12", "map.exr"}, // the helper's first writes: the header
        {whole, "pwrite64:error=EIO:when=70+", "map.exr"},   // its pixels, or the table behind them
        {whole, "fsync:error=EIO:when=1", "map.exr"},
        {whole, "rename:error=ENOSPC:when=1", "map.exr"},
        {band, "pwrite64:error=ENOSPC:when=1", "map.band"},
        {band, "pwrite64:error=ENOSPC:when=4", "map.band"}, // the footer
        {band, "fsync:error=EIO:when=1", "map.band"},
        {merge, "pwrite64:error=ENOSPC:when=1", "map.exr"},
        {merge, "pwrite64:error=ENOSPC:when=40+", "map.exr"},
        {merge, "fsync:error=EIO:when=1", "map.exr"},
    };
    for (const auto& [arguments, fault, target] : faults) {
        CAPTURE(arguments, fault);
        CHECK(traced("-e inject=" + fault, arguments) == 74);
        const std::string words = bytes_of(work_folder() / "stderr");
        CAPTURE(words);
        CHECK(bytes_of(work_folder() / "trace").find("(INJECTED)") != std::string::npos);
        CHECK(std::count(words.begin(), words.end(), '\n') == 1);
        CHECK(bytes_of(work_folder() / target) == previous);
        CHECK(count_strays() == 0);
    }
}

TEST_CASE("Working space that is lost under a bake ends it with one line, and nothing stays behind") {
    REQUIRE(run_tool("bench terrain -o long.tif --width 4096 --height 2048").status == 0);
    // The heights' nameless file, cut off as a failing disk would.
    const std::string script = "cd '" + work_folder().string() + "' || exit; '" + RELIEFBAKE_BINARY +
                               "' cone long.tif -o lost.band --rows 0:2048 --threads 1 --tolerance 0 --quiet 2>stderr & tool=$!; sleep 1; "
                               "for fd in /proc/$tool/fd/*; do case $(readlink $fd) in *'(deleted)') : >$fd;; esac; done; wait $tool";
    CHECK(shell_status(std::system(script.c_str())) == 74);
    const std::string words = bytes_of(work_folder() / "stderr");
    CAPTURE(words);
    CHECK(words.find("working space") != std::string::npos);
    CHECK(std::count(words.begin(), words.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(work_folder() / "lost.band"));
    CHECK(count_strays() == 0);
}

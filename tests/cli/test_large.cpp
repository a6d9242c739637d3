// Maps baked out of core, and by bands in processes of their own, have the bytes of maps baked at once.

#include "tests/cli/json_schema.h"
#include "tests/cli/run_tool.h"
#include "tests/cli/running_tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

using namespace reliefbake::test;
using namespace std::chrono_literals;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Runs and expects success and silence on stderr.
std::string run_well(const std::string& arguments) {
    const Outcome run = run_tool(arguments);
    INFO(arguments << "\n" << run.err);
    REQUIRE(run.status == 0);
    return run.out;
}

/// Height maps of odd sizes, as tools for terrain write them: tiles of integers, scanlines of floats, tiles of halfs.
void write_inputs() {
    static const bool once = [] {
        run_well("bench terrain -o tiles.tif --width 301 --height 517");
        run_well("bench terrain -o flat.tif --width 700 --height 65 --seed 2");
        run_well("cone tiles.tif -o floats.exr --channels depth --bits float --quiet");
        run_well("cone tiles.tif -o halfs.exr --channels depth --bits half --mips --quiet");
        run_well("cone flat.tif -o lines.tif --channels depth --bits 8 --quiet");
        return true;
    }();
    REQUIRE(once);
}

json schema(const std::string& name) {
    std::ifstream file(std::string(RELIEFBAKE_SCHEMA_DIR) + "/" + name + ".schema.json");
    return json::parse(file);
}

/// Files in the work folder that no run may leave.
int count_strays() {
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(work_folder())) count += entry.path().filename().string().starts_with(".reliefbake-");
    return count;
}

void require_same_bytes(const std::string& command, const std::string& extension) {
    CAPTURE(command);
    run_well(command + " -o whole" + extension + " --quiet");
    run_well(command + " -o large" + extension + " --out-of-core --quiet");
    const std::string whole = bytes_of(work_folder() / ("whole" + extension));
    REQUIRE(whole.size() > 1000);
    REQUIRE(bytes_of(work_folder() / ("large" + extension)) == whole);
}

void expect_refusal(const std::string& arguments, int status, const std::string& words) {
    const Outcome run = run_tool(arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.status == status);
    CHECK(run.err.find(words) != std::string::npos);
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    CHECK(count_strays() == 0);
}

} // namespace

TEST_CASE("A map baked out of core has the bytes of the map baked at once") {
    write_inputs();
    const struct {
        const char* command;
        const char* extension;
    } maps[] = {
        {"cone tiles.tif --wrap repeat", ".tif"},
        {"cone tiles.tif --wrap clamp --bits 8 --encoding ratio --threads 1", ".tif"},
        {"cone tiles.tif --wrap clamp,repeat --encoding radius", ".exr"},
        {"cone tiles.tif --bits half --input depth --scale 0.5 --bias 0.25 --normal-y dx", ".exr"},
        {"cone tiles.tif --bits half", ".tif"},
        {"cone tiles.tif --bits float --encoding normal --cone-max inf --exr-layout named", ".exr"},
        {"cone tiles.tif --channels cone,depth --metric l1 --tolerance 0", ".tif"},
        {"cone tiles.tif --lookup cell --encoding radius --bits 16 --pixel-aspect 1.4", ".tif"},
        {"cone-normal floats.exr --input depth --surface texel", ".exr"},
        {"cone halfs.exr --range data --wrap repeat,clamp --size 2000m --depth 300m", ".exr"},
        {"cone lines.tif", ".tif"},
        {"cone flat.tif --wrap repeat --bits 8", ".tif"},
    };
    for (const auto& map : maps) require_same_bytes(map.command, map.extension);
    CHECK(count_strays() == 0);
}

TEST_CASE("Bands of processes of their own, merged in any order, have the bytes of one run") {
    write_inputs();
    const std::string command = "cone tiles.tif --wrap repeat --bits half --encoding radius ";
    run_well(command + "-o whole.exr --quiet");
    const char* rows[] = {"0:64", "64:320", "320:512", "512:517"};
    for (const char* band : rows) {
        const json told = json::parse(run_well(command + "-o b" + std::string(band, std::string(band).find(':')) + ".band --rows " + band + " --json"));
        CHECK(schema_fault(told, schema("cone")) == "");
        CHECK_FALSE(told["statistics"].contains("ratio_mean"));
    }
    const json told = json::parse(run_well("merge b320.band b0.band b512.band b64.band -o merged.exr --json"));
    CHECK(schema_fault(told, schema("merge")) == "");
    CHECK(told["bands"][1]["rows"] == json::array({64, 320}));
    REQUIRE(bytes_of(work_folder() / "merged.exr") == bytes_of(work_folder() / "whole.exr"));
    CHECK(run_well("merge b320.band b0.band b512.band b64.band -o merged2.exr").find("from 4 bands") != std::string::npos);

    // What does not make one map.
    run_well("cone tiles.tif --wrap repeat --bits half --encoding ratio -o other.band --rows 64:320 --quiet");
    expect_refusal("merge b0.band b64.band b512.band -o no.exr", 65, "rows 320:512 before it are in no band");
    expect_refusal("merge b0.band b64.band b320.band -o no.exr", 65, "rows 512:517 behind it are in no band");
    expect_refusal("merge b0.band b64.band b64.band b320.band b512.band -o no.exr", 65, "rows 64:320 are in another band too");
    expect_refusal("merge b0.band other.band b320.band b512.band -o no.exr", 65, "other.band: is of another map than b0.band");
    expect_refusal("merge b0.band tiles.tif -o no.exr", 65, "tiles.tif: is no band");
    expect_refusal("merge b0.band none.band -o no.exr", 66, "none.band: cannot open");
    expect_refusal("merge b0.band b64.band b320.band b512.band -o no.png", 2, "no.png: ");
    expect_refusal("merge b0.band b64.band b320.band b512.band -o no.tga", 2, "no.tga: ");

    // One byte of a pixel, of a sum, of the text; and a file cut off.
    const std::string good = bytes_of(work_folder() / "b512.band");
    for (const std::size_t at : {std::size_t(7), good.size() / 2, good.size() - 300, good.size() - 30, good.size() - 5}) {
        CAPTURE(at, good.size());
        std::string bad = good;
        bad[at] = char(bad[at] ^ 4);
        std::ofstream(work_folder() / "bad.band", std::ios::binary) << bad;
        const Outcome run = run_tool("merge b0.band b64.band b320.band bad.band -o no.exr");
        CHECK(run.status == 65);
        CHECK(run.err.find("bad.band: ") != std::string::npos);
    }
    for (const std::size_t size : {std::size_t(0), std::size_t(39), good.size() / 3, good.size() - 1}) {
        std::ofstream(work_folder() / "bad.band", std::ios::binary) << good.substr(0, size);
        expect_refusal("merge b0.band b64.band b320.band bad.band -o no.exr", 65, "bad.band: is no band");
    }
    CHECK_FALSE(fs::exists(work_folder() / "no.exr"));
}

TEST_CASE("A map that needs more than the ceiling is baked out of core, and the report says so") {
    write_inputs();
    run_well("bench terrain -o big.tif --width 1500 --height 2000");
    const auto told = [](const std::string& options) { return json::parse(run_well("cone big.tif -o big.exr --json " + options)); };
    CHECK_FALSE(told("").contains("out_of_core"));
    const json large = told("--memory 430MiB");
    CHECK(schema_fault(large, schema("cone")) == "");
    REQUIRE(large.contains("out_of_core"));
    CHECK(large["out_of_core"]["memory"] == 430u << 20);
    CHECK(run_well("cone flat.tif -o flat.exr --out-of-core").find("out of core: ") != std::string::npos);
    CHECK(large["out_of_core"]["rows"] == json::array({0, 2000}));
    expect_refusal("cone big.tif -o big.exr --memory 300MiB", 5, "need");
    expect_refusal("cone big.tif -o big.png --memory 430MiB", 5, "only .exr and .tif");
    expect_refusal("cone " + height_map("ambientcg_RoofingTiles009_512.png") + " -o big.exr --memory 300MiB", 5, "only EXR and TIFF files are baked out of core");
}

TEST_CASE("What bands cannot have is refused, never left out") {
    write_inputs();
    const std::pair<const char*, const char*> lacks[] = {
        {"--mips", "--mips"},
        {"--kind relaxed", "--kind"},
        {"--kind hybrid --delta 0.1", "--kind"},
        {"--level 1", "--level"},
        {"--alpha tiles.tif", "--alpha"},
        {"--nan fill", "--nan fill"},
        {"--channels depth", "--channels"},
        {"--also 'cone -o other.exr'", "--also"},
    };
    for (const auto& [options, word] : lacks) {
        expect_refusal("cone tiles.tif -o no.exr --out-of-core " + std::string(options), 2, std::string("cannot be had with ") + word);
        expect_refusal("cone tiles.tif -o no.band --rows 0:64 " + std::string(options), 2, std::string("cannot be had with ") + word);
    }
    expect_refusal("cone tiles.tif -o no.png --out-of-core", 2, "only .exr and .tif");
    expect_refusal("cone tiles.tif -o no.exr --rows 0:64", 2, ".band");
    expect_refusal("cone tiles.tif -o no.band --rows 0:100", 2, "multiples of 64, or 517");
    expect_refusal("cone tiles.tif -o no.band --rows 64:576", 2, "has rows 0:517");
    expect_refusal("cone none.tif -o no.exr --out-of-core", 66, "none.tif");
    expect_refusal("cone " + height_map("pom_rocks_NM_height.tga") + " -o no.exr --out-of-core", 2, "only EXR and TIFF files");
    CHECK(run_tool("cone tiles.tif -o no.band --rows 64").status == 2);
    CHECK(run_tool("cone tiles.tif -o no.exr --also 'cone -o x.exr --out-of-core'").status == 2);
    CHECK_FALSE(fs::exists(work_folder() / "no.exr"));
    CHECK_FALSE(fs::exists(work_folder() / "no.band"));
}

TEST_CASE("A signal ends a bake out of core at once, and nothing stays behind") {
    run_well("bench terrain -o long.tif --width 4096 --height 2048");
    for (const int signal : {SIGINT, SIGTERM})
        for (const auto& arguments : {std::vector<std::string>{"cone", "long.tif", "-o", "stopped.exr", "--out-of-core", "--threads", "1", "--tolerance", "0"},
                                      {"cone", "long.tif", "-o", "stopped.band", "--rows", "0:2048", "--threads", "1", "--tolerance", "0"}}) {
            RunningTool tool(arguments);
            std::this_thread::sleep_for(700ms);
            REQUIRE(tool.is_running());
            tool.signal(signal);
            CHECK(tool.wait(2000ms) == 128 + signal);
            CHECK_FALSE(fs::exists(work_folder() / arguments[3]));
            CHECK(count_strays() == 0);
        }
}

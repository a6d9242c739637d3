#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace reliefbake::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

void write_inputs() {
    write_pgm(work_folder() / "stone.pgm", 75, 54, [](int x, int y) { return (x * x * 7 + y * 13 + x * y) % 251; });
    write_pgm(work_folder() / "mask.pgm", 75, 54, [](int x, int y) { return x > 20 && x < 40 && y > 10 && y < 30 ? 0 : 255; });
}

/// Files of the work folder that begin so.
std::vector<std::string> files(const std::string& start) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(work_folder()))
        if (entry.path().filename().string().rfind(start, 0) == 0) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

TEST_CASE("Maps of one run have the bytes of maps baked alone") {
    write_inputs();
    const std::string source = " stone.pgm --alpha mask.pgm --wrap repeat,clamp --depth-uv 0.07 ";
    const std::string maps[] = {
        "cone -o ?0.png",
        "cone -o ?1.exr --encoding ratio",
        "cone -o ?2.tif --encoding normal --bits 16", // the same cones as ?0, other codes
        "cone-normal -o ?3.exr",
        "acm -o ?4.png --sectors 8 --layout pair --relief ?4r.png",
        "acm -o ?5.exr --sectors 8",
        "acm -o ?6.png --kind relaxed",
        "cone -o ?7.exr --kind relaxed --relaxed top",
        "cone -o ?8.exr --kind hybrid --delta 0.1",
        "cone-stack -o ?9.exr --levels 3",
        "cone -o ?10.png --mips --trilinear --bits 8",
        "cone -o ?11.exr --mips",
        "cone -o ?12.png --metric l1 --lookup cell",
        "acm -o ?13.png --method adaptive --levels 2",
        "cone -o ?14.dds --tolerance 0 --cone-max 3",
        "cone -o ?15.png --channels cone,depth --level 1",
        "cone -o ?16.tif --channels normal,depth --bits 16",
        "cone -o ?17.ktx2 --channels depth --level 2 --mips --mip-levels 3",
        "cone-normal -o ?18.exr --level 2 --channels cone,depth",
    };
    const auto named = [](std::string map, const std::string& stem) {
        for (std::size_t at = map.find('?'); at != map.npos; at = map.find('?')) map.replace(at, 1, stem);
        return map;
    };
    std::string together;
    for (const std::string& map : maps) {
        const std::string alone = named(map, "alone");
        const std::size_t space = alone.find(' ');
        const Outcome outcome = run_tool(alone.substr(0, space) + source + alone.substr(space) + " --quiet");
        INFO(alone << "\n" << outcome.err);
        REQUIRE(outcome.status == 0);
        together += (together.empty() ? named(map, "shared").substr(4) + source : " --also '" + named(map, "shared") + "'");
    }
    const Outcome outcome = run_tool("cone" + together + " --json");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const std::vector<std::string> alone = files("alone"), shared = files("shared");
    REQUIRE(alone.size() == 19 + 2 + 6); // the second of a pair and a relief file; seven numbered levels
    REQUIRE(shared.size() == alone.size());
    for (std::size_t k = 0; k < alone.size(); ++k) {
        CAPTURE(alone[k]);
        CHECK(shared[k].substr(6) == alone[k].substr(5));
        CHECK(bytes_of(work_folder() / shared[k]) == bytes_of(work_folder() / alone[k]));
    }

    const json result = json::parse(outcome.out);
    CHECK(schema_fault(result, json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/cone.schema.json"))) == "");
    REQUIRE(result["also"].size() == 18);
    CHECK(result["output"] == "shared0.png");
    CHECK(result["also"][2]["output"] == "shared3.exr");
    CHECK(result["also"][3]["map"]["kind"] == "acm");
    CHECK_FALSE(result["also"][1]["seconds"].contains("cone")); // taken from the first map
    CHECK_FALSE(result["also"][1]["seconds"].contains("quantise"));
    CHECK(result["also"][9]["levels"].size() == 7);
    CHECK(files(".reliefbake").empty());
}

TEST_CASE("Without --json each map has its lines") {
    write_inputs();
    const Outcome outcome = run_tool("cone stone.pgm -o lines.png --also 'acm -o \"lines 2.png\"'");
    CHECK(outcome.status == 0);
    CHECK(outcome.out.find("lines.png: 75 x 54") == 0);
    CHECK(outcome.out.find("\nlines 2.png: 75 x 54") != std::string::npos);
    CHECK(fs::exists(work_folder() / "lines 2.png"));
}

TEST_CASE("Outputs that would meet are refused before anything is written") {
    write_inputs();
    fs::create_directory(work_folder() / "folder");
    fs::create_directory_symlink("folder", work_folder() / "other_name");
    struct Meeting {
        const char *first, *also;
    };
    const Meeting meetings[] = {
        {"cone stone.pgm -o met.png", "acm -o met.png"},
        {"cone stone.pgm -o met.png", "acm -o ./folder/../met.png"},
        {"cone stone.pgm -o met.png", "acm -o MET.png"},
        {"cone stone.pgm -o folder/met.png", "acm -o other_name/met.png"},
        {"acm stone.pgm -o met.png --relief met_relief.png", "cone -o met_relief.png"},
        {"acm stone.pgm --sectors 8 --layout pair -o met.png", "cone -o met_b.png"},
        {"cone stone.pgm -o met.png --mips", "cone -o met_mip3.png"},
    };
    for (const Meeting& meeting : meetings) {
        CAPTURE(meeting.first, meeting.also);
        const Outcome outcome = run_tool(std::string(meeting.first) + " --also '" + meeting.also + "'");
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find("two maps of this run") != std::string::npos);
        CHECK(files("met").empty());
        CHECK(fs::is_empty(work_folder() / "folder"));
    }
    const std::string before = bytes_of(work_folder() / "mask.pgm");
    fs::copy_file(work_folder() / "mask.pgm", work_folder() / "mask.png", fs::copy_options::overwrite_existing);
    for (const std::string own : {"mask.png"}) {
        const Outcome outcome = run_tool("cone stone.pgm --alpha mask.png -o met.png --also 'acm -o " + own + "'");
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find("is the input file") != std::string::npos);
        CHECK(bytes_of(work_folder() / "mask.png") == before);
        CHECK(files("met").empty());
    }
}

TEST_CASE("What --also cannot say is refused, and the message names it") {
    write_inputs();
    struct Refusal {
        const char* also;
        int status;
        const char* names;
    };
    const Refusal refusals[] = {
        {"", 2, "expected cone, acm, cone-normal or cone-stack"},
        {"verify", 2, "found 'verify'"},
        {"acm", 2, "--output is required"},
        {"acm -o never.png other.pgm", 2, "IN is the run's"},
        {"acm -o never.png --sectors 5", 2, "--sectors"},
        {"acm -o never.png --kind hybrid", 2, "--kind"},
        {"acm -o never.png --levels 2", 2, "--method adaptive"},
        {"cone -o never.png --delta 0.1", 2, "--kind hybrid"},
        {"cone -o never.jpg", 2, "jpg"},
        {"cone -o no/folder/never.png", 73, "no/folder"},
        {"cone -o never.png --also cone", 2, "--also: is one for all maps"},
        {"cone -o never.png --no-such", 2, "no such option: --no-such"},
        {"cone -o never.png --channel R", 2, "--channel: is one for all maps"},
        {"cone -o never.png --wrap=clamp", 2, "--wrap: is one for all maps"},
        {"cone -o never.png --alpha mask.pgm", 2, "--alpha: is one for all maps"},
        {"cone -o never.png --depth-uv 0.2", 2, "--depth-uv: is one for all maps"},
        {"cone -o never.png --range data", 2, "--range: is one for all maps"},
        {"cone -o never.png --threads 2", 2, "--threads: is one for all maps"},
        {"cone -o never.png --json", 2, "--json: is one for all maps"},
    };
    for (const Refusal& refusal : refusals) {
        CAPTURE(refusal.also);
        const Outcome outcome = run_tool(std::string("cone stone.pgm -o never_first.png --also '") + refusal.also + "'");
        CHECK(outcome.status == refusal.status);
        INFO(outcome.err);
        CHECK(outcome.err.find(std::string("--also '") + refusal.also + "': ") != std::string::npos);
        CHECK(outcome.err.find(refusal.names) != std::string::npos);
        CHECK(outcome.out.empty());
        CHECK(files("never").empty());
    }
    CHECK(run_tool("shape --also 'cone -o x.png' -o y.png stone.pgm").status == 2);
}

TEST_CASE("Where one map cannot be written, none appears") {
    write_inputs();
    fs::create_directory(work_folder() / "blocked.png");
    { std::ofstream(work_folder() / "earlier.png") << "previous"; }
    const Outcome outcome = run_tool("cone stone.pgm -o earlier.png --also 'cone-normal -o new.exr' --also 'acm -o blocked.png' --json");
    CHECK(outcome.status == 73);
    CHECK(outcome.err.find("blocked.png") != std::string::npos);
    CHECK(outcome.out.empty());
    CHECK(bytes_of(work_folder() / "earlier.png") == "previous");
    CHECK_FALSE(fs::exists(work_folder() / "new.exr"));
    CHECK(files(".reliefbake").empty());
}

TEST_CASE("bench also compares runs apart and together") {
    write_inputs();
    const Outcome outcome = run_tool("bench also stone.pgm --repeat 1 --threads 1 --map cone --map 'acm --sectors 8' --json");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const json result = json::parse(outcome.out);
    CHECK(result["maps"].size() == 2);
    CHECK(result["apart_seconds"] > 0);
    CHECK(result["together_seconds"] > 0);
    CHECK(result["together_stages"].contains("read"));
    CHECK(run_tool("bench also stone.pgm --repeat 1").out.find("% saved") != std::string::npos);
}

TEST_CASE("Channels and levels that are not wanted are neither baked nor held") {
    write_inputs();
    const auto baked = [](const std::string& options) {
        const Outcome outcome = run_tool("cone stone.pgm --wrap repeat -o held.exr --json " + options);
        INFO(options << ": " << outcome.err);
        REQUIRE(outcome.status == 0);
        return json::parse(outcome.out);
    };
    const json depth = baked("--channels depth");
    CHECK(depth["map"]["channels"] == json({"-", "-", "-", "Y"}));
    CHECK_FALSE(depth["seconds"].contains("cone_search"));
    CHECK_FALSE(depth["statistics"].contains("ratio_mean"));
    CHECK(depth["map"]["guarantee"] == "");
    CHECK(run_tool("verify held.exr --source stone.pgm --rays 2000 --points 0 --crop 0").status == 0);
    CHECK(run_tool("explain held.exr").out.find("the cones") == std::string::npos);
    CHECK(run_tool("explain held.exr").out.find("depth   Y") != std::string::npos);

    // A level alone is the level of the whole chain.
    REQUIRE(run_tool("cone stone.pgm --wrap repeat -o chain.png --mips").status == 0);
    REQUIRE(run_tool("cone stone.pgm --wrap repeat -o level.png --level 2").status == 0);
    const auto facts = [](const std::string& file) { return json::parse(run_tool("explain " + file + " --json").out); };
    CHECK(facts("level.png")["width"] == 18);
    CHECK(facts("level.png")["statistics"] == facts("chain_mip2.png")["statistics"]);
    const json few = baked("--mips --mip-levels 2");
    CHECK(few["levels"].size() == 2);

    for (const char* refused : {"--channels cone", "--channels depth,depth", "--channels normal,depth,", "--channels ''", "--channels depth --encoding ratio",
                                "--channels depth --kind relaxed", "--channels cone,depth --normal-y dx", "--level 9", "--mip-levels 2", "--channels depth --mips --trilinear"}) {
        INFO(refused);
        CHECK(run_tool(std::string("cone stone.pgm --wrap repeat -o refused.exr ") + refused).status == 2);
    }
    CHECK(files("refused").empty());
}

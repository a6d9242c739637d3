// reliefbake tradeoff, from outside.

#include "tests/cli/json_schema.h"
#include "tests/cli/run_tool.h"
#include "tests/cli/running_tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

using namespace reliefbake::test;
using namespace std::chrono_literals;
using nlohmann::json;

namespace {

const std::string some = " --quick --techniques linear,cone,max-mip --steps 8,512 ";

json json_of(const std::filesystem::path& file) {
    const json parsed = json::parse(bytes_of(file), nullptr, false);
    REQUIRE_FALSE(parsed.is_discarded());
    return parsed;
}

/// Without what differs from run to run.
json without_times(json result) {
    for (json& input : result["inputs"]) {
        input.erase("fronts"); // that of time
        for (json& point : input["measurements"])
            for (const char* time : {"bake_seconds", "ms_per_frame", "cpu_ms_per_frame"}) point["figures"].erase(time);
    }
    return result;
}

std::size_t lines_of(const std::filesystem::path& file) {
    const std::string text = bytes_of(file);
    return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

} // namespace

TEST_CASE("a sweep of heights writes tables, plots and a page that is whole") {
    const Outcome run = run_tool("tradeoff " + height_map("gz_dem_squared_129.tif") + some + "-o sweep");
    CHECK(run.status == 0);
    CHECK(run.err == "");
    CHECK(run.out.find("6 measurements, 6 of them new") != std::string::npos);
    const json result = json_of(work_folder() / "sweep/tradeoff.json");
    CHECK(schema_fault(result, json_of(RELIEFBAKE_SCHEMA_DIR "/tradeoff.schema.json")) == "");
    CHECK(lines_of(work_folder() / "sweep/tradeoff.csv") == 7);

    // What is exact misses nothing; a linear search of 8 steps does.
    for (const json& point : result["inputs"][0]["measurements"]) {
        CAPTURE(point["candidate"]["id"].get<std::string>());
        const double missed = point["figures"]["missed"].get<double>();
        if (point["method"] == "linear" && point["candidate"]["steps"] == 8) CHECK(missed > 0.01);
        if (point["method"] != "linear") CHECK(missed == 0);
        CHECK(point["figures"]["instructions"].get<double>() > 100);
    }
    for (const char* file : {"tradeoff.html", "gz_dem_squared_129-steps.svg", "gz_dem_squared_129-fetches.svg", "gz_dem_squared_129-instructions.svg", "gz_dem_squared_129-time.svg"}) {
        CAPTURE(file);
        CHECK(std::system(("xmllint --nonet --noout '" + (work_folder() / "sweep" / file).string() + "'").c_str()) == 0);
    }
    const std::string page = bytes_of(work_folder() / "sweep/tradeoff.html");
    CHECK(page.find("data:image/png;base64,iVBORw0KGgo") != std::string::npos);
    for (const char* outside : {"src=\"http", "href=", "url(", "<script"}) CHECK(page.find(outside) == std::string::npos);

    // Again: nothing is measured, nothing changes.
    const Outcome again = run_tool("tradeoff " + height_map("gz_dem_squared_129.tif") + some + "-o sweep");
    CHECK(again.status == 0);
    CHECK(again.out.find("6 measurements, 0 of them new") != std::string::npos);
    CHECK(json_of(work_folder() / "sweep/tradeoff.json") == result);
    CHECK(bytes_of(work_folder() / "sweep/tradeoff.html") == page);
    // Other conditions are other measurements.
    CHECK(run_tool("tradeoff " + height_map("gz_dem_squared_129.tif") + some + "-o sweep --angle 70").out.find("6 of them new") != std::string::npos);
}

TEST_CASE("an interrupted sweep leaves at once, keeps what is finished, and goes on to the same figures") {
    const std::string height = height_map("gz_dem_squared_129.tif");
    const std::string path = height.substr(1, height.size() - 2);
    const std::vector<std::string> words = {"tradeoff", path, "--techniques", "cone,relaxed,linear", "--bits", "16", "--rays", "28000", "-o", "cut"};
    const std::filesystem::path record = work_folder() / "cut/measurements.jsonl";
    {
        RunningTool tool(words);
        const auto deadline = std::chrono::steady_clock::now() + 60s;
        while (tool.is_running() && (!std::filesystem::exists(record) || lines_of(record) < 3) && std::chrono::steady_clock::now() < deadline) std::this_thread::sleep_for(2ms);
        REQUIRE(tool.is_running());
        tool.signal(SIGINT);
        CHECK(tool.wait(2000ms) == 130);
    }
    const std::size_t kept = lines_of(record);
    CHECK(kept >= 3);
    std::string rest;
    for (const std::string& word : words) rest += " '" + word + "'";
    const Outcome resumed = run_tool(rest);
    CHECK(resumed.status == 0);
    const json finished = json_of(work_folder() / "cut/tradeoff.json");
    const std::size_t points = finished["inputs"][0]["measurements"].size();
    CHECK(kept < points);
    CHECK(resumed.out.find(std::to_string(points - kept) + " of them new") != std::string::npos);
    CHECK(run_tool(rest + " -o whole").status == 2); // -o twice
    rest.replace(rest.find("'cut'"), 5, "'whole'");
    CHECK(run_tool(rest).status == 0);
    CHECK(without_times(json_of(work_folder() / "whole/tradeoff.json")) == without_times(finished));
}

TEST_CASE("a baked map is measured as far as it allows, and one with widened cones is found out") {
    REQUIRE(run_tool("cone " + height_map("gz_dem_squared_129.tif") + " -o right.exr --quiet").status == 0);
    REQUIRE(run_tool("tradeoff right.exr --quick --steps 512 -o baked").status == 0);
    const auto missed_by_cones = [](const std::filesystem::path& file) {
        double missed = -1;
        const json result = json_of(file);
        for (const json& point : result["inputs"][0]["measurements"])
            if (point["method"] == "cone") missed = point["figures"]["missed"].get<double>();
        return missed;
    };
    std::set<std::string> methods;
    const json result = json_of(work_folder() / "baked/tradeoff.json");
    for (const json& point : result["inputs"][0]["measurements"]) methods.insert(point["method"].get<std::string>());
    CHECK(methods == std::set<std::string>{"linear", "binary", "interval", "cone", "max-mip", "exact-finish"});
    CHECK(missed_by_cones(work_folder() / "baked/tradeoff.json") == 0);

    std::string bytes = bytes_of(work_folder() / "right.exr");
    const std::size_t at = bytes.find("\"cone_max\":1");
    REQUIRE(at != std::string::npos);
    bytes[at + 11] = '4';
    std::ofstream(work_folder() / "wide.exr", std::ios::binary) << bytes;
    REQUIRE(run_tool("tradeoff wide.exr --quick --steps 512 -o wide").status == 0);
    CHECK(missed_by_cones(work_folder() / "wide/tradeoff.json") > 0.001);
}

TEST_CASE("what a sweep cannot do is refused in a line") {
    const std::string height = height_map("gz_dem_squared_129.tif");
    const auto refused = [](const std::string& arguments, const std::string& expected, int status = 2) {
        const Outcome run = run_tool("tradeoff " + arguments);
        CAPTURE(arguments, run.err);
        CHECK(run.status == status);
        CHECK(run.err.find(expected) != std::string::npos);
    };
    refused("", "FILES");
    refused("absent.png -o a", "absent.png", 66);
    refused(height + " --techniques cone,magic", "found 'magic'");
    refused(height + " --techniques cone,cone", "each once");
    refused(height + " --steps 8,x", "found 'x'");
    refused(height + " --steps 0", "found '0'");
    refused(height + " --bits 12", "found '12'");
    refused(height + " --resolutions 0.3", "found '0.3'");
    refused(height + " --resolutions 2", "found '2'");
    refused(height + " --tolerances 2", "--tolerances");
    refused(height + " --crop 500 -o a", "--crop");
    refused(height + " --quick --resolutions 0.001953125 -o a", "mip levels");
    std::ofstream(work_folder() / "file") << "x";
    refused(height + " --quick -o file", "cannot create", 73);
}

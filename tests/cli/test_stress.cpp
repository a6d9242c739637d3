// reliefbake stress, from outside.

#include "tests/cli/json_schema.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <map>
#include <set>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

json json_of(const std::string& text) {
    const json parsed = json::parse(text, nullptr, false);
    REQUIRE_FALSE(parsed.is_discarded());
    return parsed;
}

/// How often each case was baked.
std::map<std::string, int> bakes_of(const json& report) {
    std::map<std::string, int> bakes;
    for (const json& one : report["cases"]) ++bakes[one["case"].get<std::string>()];
    return bakes;
}

} // namespace

TEST_CASE("quick: every case is there, in every encoding, and holds; tables and plots are whole") {
    const Outcome run = run_tool("stress --quick -o report");
    CHECK(run.status == 0);
    CHECK(run.err == "");
    const json report = json_of(bytes_of(work_folder() / "report/stress.json"));
    CHECK(schema_fault(report, json_of(bytes_of(RELIEFBAKE_SCHEMA_DIR "/stress.schema.json"))) == "");
    CHECK(report["violated"] == 0);

    const auto bakes = bakes_of(report);
    for (const char* name : {"offset-1e6-detail-1e-3", "denormals", "plateaus", "walls", "white-noise", "size-1x1", "size-1024x16", "size-16x1024", "depth-scale-1e-4-hills", "depth-scale-1e4-white-noise",
                             "pixel-aspect-2"}) {
        CAPTURE(name);
        REQUIRE(bakes.contains(name));
        CHECK(bakes.at(name) == 16); // 2 depths, 2 addressings, 4 encodings
        CHECK(run.out.find(name) != std::string::npos);
    }
    std::set<std::string> encodings, bits;
    std::uint64_t rays = 0, points = 0, exact = 0;
    for (const json& one : report["cases"]) {
        encodings.insert(one["encoding"].get<std::string>()), bits.insert(one["bits"].get<std::string>());
        CHECK(one["holds"] == true);
        CHECK((one["judge"] == "rationals") == one["exact"].is_object());
        rays += one["rays"]["rays"].get<std::uint64_t>(), points += one["doubles"]["points"].get<std::uint64_t>();
        if (one["exact"].is_object()) exact += one["exact"]["points"].get<std::uint64_t>();
    }
    CHECK(encodings == std::set<std::string>{"ratio", "sqrt", "radius", "normal"});
    CHECK(bits == std::set<std::string>{"8", "float"});
    CHECK(rays > 100 * report["cases"].size());
    CHECK(points == 400 * report["cases"].size());
    CHECK(exact > 1000);

    std::set<std::string> compared;
    for (const json& one : report["useful"]) compared.insert(one["encoding"].get<std::string>() + one["bits"].get<std::string>());
    CHECK(compared.size() == 16);
    for (const char* file : {"kept.svg", "dead.svg"}) CHECK(std::system(("xmllint --nonet --noout '" + (work_folder() / "report" / file).string() + "'").c_str()) == 0);
}

TEST_CASE("one case alone, in every depth; the same for one thread and two") {
    const Outcome one = run_tool("stress --quick --only walls --json --threads 1"), two = run_tool("stress --quick --only walls --json --threads 2");
    CHECK(one.status == 0);
    CHECK(one.out == two.out);
    CHECK(bakes_of(json_of(one.out)) == std::map<std::string, int>{{"walls", 16}});
    const json report = json_of(run_tool("stress --only plateaus --json").out);
    CHECK(schema_fault(report, json_of(bytes_of(RELIEFBAKE_SCHEMA_DIR "/stress.schema.json"))) == "");
    CHECK(bakes_of(report) == std::map<std::string, int>{{"plateaus", 32}});
    for (const json& bake : report["cases"]) CHECK(bake["levels"] == 2);
    CHECK(bakes_of(json_of(run_tool("stress --quick --only pixel-aspect --json").out)).size() == 2);
}

TEST_CASE("what stress cannot do is refused in a line") {
    const auto refused = [](const std::string& arguments, const std::string& expected, int status = 2) {
        const Outcome run = run_tool("stress " + arguments);
        CAPTURE(arguments, run.err);
        CHECK(run.status == status);
        CHECK(run.err.find(expected) != std::string::npos);
    };
    refused("--only nonsense", "no case begins with 'nonsense'");
    refused("--quick --only size-16384x1", "no case begins with");
    refused("--only size-16384x16384", "no case begins with");
    refused("--only ''", "--only");
    refused("--quick --full", "--quick");
    refused("--threads 0", "--threads");
    refused("height.png", "height.png");
    std::ofstream(work_folder() / "file") << "x";
    refused("--quick --only constant -o file", "cannot create", 73);
}

#include "tests/cli/json_schema.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <set>
#include <string>

using namespace reliefbake::test;
using nlohmann::json;

TEST_CASE("--describe json names every command and option of --help") {
    const Outcome described = run_tool("--describe json");
    REQUIRE(described.status == 0);
    const json tool = json::parse(described.out);
    CHECK(schema_fault(tool, json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/describe.schema.json"))) == "");
    std::set<std::string> paths;
    for (const json& command : tool.at("commands")) {
        const std::string path = command.at("path");
        paths.insert(path);
        INFO(path);
        const std::string help = run_tool(path + " --help").out;
        CHECK(help.find(command.at("summary").get<std::string>()) != std::string::npos);
        for (const json& option : command.at("options"))
            for (const std::string name : option.at("names")) CHECK(help.find(name) != std::string::npos);
    }
    for (const char* path : {"cone", "acm", "shape", "quadric", "bench cone", "verify"}) CHECK(paths.contains(path));
    CHECK_FALSE(paths.contains("bench"));
}

TEST_CASE("--describe tells words from kinds of values, flags, arguments and what excludes what") {
    const json tool = json::parse(run_tool("--describe json").out);
    const auto option = [&](const std::string& path, const std::string& name) {
        for (const json& command : tool.at("commands"))
            for (const json& candidate : command.at("options"))
                if (command.at("path") == path && (candidate.at("positional").get<bool>() ? candidate.at("value") == name : candidate.at("names").back() == name)) return candidate;
        FAIL("no " + name);
        return json();
    };
    CHECK(option("cone", "--encoding").at("words") == json({"ratio", "sqrt", "radius", "normal"}));
    CHECK(option("cone", "--json").at("value").is_null());
    CHECK(option("cone", "--output").at("required") == true);
    CHECK(option("cone", "--quiet").at("excludes") == json({"--json"}));
    CHECK(option("explain", "--histogram").at("needs") == json({"--json"}));
    CHECK(option("acm", "--sectors").at("words") == json({"4", "8"}));
    CHECK(option("explain", "--histogram").at("value") == "INT");
    CHECK(option("explain", "--histogram").at("most") == 4096);
    CHECK(option("tradeoff", "MAP|HEIGHT").at("words").empty());
    CHECK(option("tradeoff", "MAP|HEIGHT").at("several") == true);
    CHECK(run_tool("--describe xml").status == 2);
}

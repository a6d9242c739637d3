#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <chrono>

using namespace reliefbake::test;

TEST_CASE("Help and version go to stdout and succeed") {
    for (const char* arguments : {"--help", "--version", "cone --help", "explain --help"}) {
        const Outcome outcome = run_tool(arguments);
        CHECK(outcome.status == 0);
        CHECK_FALSE(outcome.out.empty());
        CHECK(outcome.err.empty());
    }
    CHECK(run_tool("--version").out.find("reliefbake 0.") == 0);
}

TEST_CASE("Help comes at once: the image library is not loaded") {
    run_tool("--help");
    double best = 1;
    for (int i = 0; i < 5; ++i) {
        const auto start = std::chrono::steady_clock::now();
        run_tool("--help");
        best =
            std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    CHECK(best < 0.05);
#endif
    const std::string libraries = (work_folder() / "libraries").string();
    std::string command = "ldd '";
    command.append(RELIEFBAKE_BINARY).append("' > '").append(libraries).append("'");
    REQUIRE(std::system(command.c_str()) == 0);
    CHECK(bytes_of(libraries).find("OpenImageIO") == std::string::npos);
}

TEST_CASE("Usage errors: status 2, a line on stderr, nothing on stdout") {
    for (const char* arguments : {"", "no-such-command", "--no-such-option", "cone", "explain", "cone a.png",
                                  "cone a.png -o b.png --no-such-option", "explain a.png b.png"}) {
        INFO(arguments);
        const Outcome outcome = run_tool(arguments);
        CHECK(outcome.status == 2);
        CHECK_FALSE(outcome.err.empty());
        CHECK(outcome.out.empty());
    }
}

TEST_CASE("A reader of stdout that cannot take the answer is an error") {
    const std::string command = std::string("'") + RELIEFBAKE_BINARY + "' cone " +
                                height_map("gz_dem_squared_129.tif") + " -o '" +
                                (work_folder() / "full.png").string() + "' --json >/dev/full 2>/dev/null";
    CHECK(std::system(command.c_str()) / 256 == 74);
}

// Ctrl-C, kill and the terminal.

#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"
#include "tests/cli/running_tool.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

using namespace reliefbake::test;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr auto soon = 2000ms;

/// Names in the work folder that begin so.
int count_names(const std::string& beginning) {
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(work_folder()))
        count += entry.path().filename().string().starts_with(beginning);
    return count;
}

bool all_gone(const std::vector<pid_t>& pids) {
    const auto deadline = std::chrono::steady_clock::now() + soon;
    for (const pid_t pid : pids)
        while (is_alive(pid)) {
            if (std::chrono::steady_clock::now() > deadline) return false;
            std::this_thread::sleep_for(5ms);
        }
    return true;
}

} // namespace

TEST_CASE("A signal ends a long bake at once, and nothing stays behind: no file, no helper") {
    write_noise(work_folder() / "long.pgm", 4096);
    for (const int signal : {SIGINT, SIGTERM})
        for (const auto age : {400ms, 1500ms}) {
            CAPTURE(signal, age.count());
            RunningTool tool({"cone", "long.pgm", "-o", "interrupted.png", "--threads", "1"});
            std::this_thread::sleep_for(age);
            REQUIRE(tool.is_running()); // the signal finds it at work
            const std::vector<pid_t> helpers = tool.children();
            CHECK_FALSE(helpers.empty());
            tool.signal(signal);
            CHECK(tool.wait(soon) == 128 + signal);
            CHECK(all_gone(helpers));
            CHECK(count_names("interrupted") == 0);
            CHECK(count_names(".reliefbake-") == 0);
        }
}

TEST_CASE("A killed tool takes its helper with it") {
    write_noise(work_folder() / "long.pgm", 4096);
    RunningTool tool({"cone", "long.pgm", "-o", "killed.png"});
    std::this_thread::sleep_for(1000ms);
    REQUIRE(tool.is_running());
    const std::vector<pid_t> helpers = tool.children();
    REQUIRE_FALSE(helpers.empty());
    tool.signal(SIGKILL);
    CHECK(tool.wait(soon) == 128 + SIGKILL);
    CHECK(all_gone(helpers));
}

TEST_CASE("Progress shows on a terminal alone, and is wiped off at the end and when interrupted") {
    const std::string wipe = "\r\033[K";
    write_noise(work_folder() / "slow.pgm", 4096); // more than two seconds on any machine
    const std::vector<std::string> bake{"cone", "slow.pgm", "-o", "slow.png", "--threads", "1"};
    const auto wiped = [&](const std::string& screen) {
        return screen.find(" s" + wipe) != screen.npos && screen.ends_with(wipe); // "STAGE 2 s", whichever stage it was
    };
    {
        RunningTool tool(bake, RunningTool::Stderr::terminal);
        const std::string screen = tool.terminal_output();
        CHECK(tool.wait(soon) == 0);
        CHECK(wiped(screen));
    }
    {
        RunningTool tool(bake, RunningTool::Stderr::terminal);
        std::this_thread::sleep_for(1500ms);
        tool.signal(SIGINT);
        CHECK(wiped(tool.terminal_output()));
        CHECK(tool.wait(soon) == 130);
    }
    const Outcome piped = run_tool("cone slow.pgm -o slow.png --threads 1");
    CHECK(piped.status == 0);
    CHECK(piped.err == "");
}

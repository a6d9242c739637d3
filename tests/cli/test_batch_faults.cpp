// reliefbake batch through faults of the disk, signals and kills: strace injects them, and each test sees that they fired.

#include "tests/cli/batch_folder.h"
#include "tests/cli/running_tool.h"

#include <csignal>
#include <thread>

using namespace reliefbake::test;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

fs::path out() { return work_folder() / "out"; }

/// Five assets of several kinds, small enough to be baked hundreds of times.
void write_sources() {
    const fs::path src = fresh_sources();
    for (int k = 0; k < 3; ++k) write_height(src / ("map" + std::to_string(k) + ".pgm"), k);
    write_height(src / "logo_mask.pgm", 4);
    write_text(src / "mesh.obj", pyramid_mesh);
}

struct Traced {
    int status;
    std::string trace, err;
    Events events;
    bool fired(const std::string& mark) const { return trace.find(mark) != std::string::npos; }
};

/// A run under strace; `inject` holds -e expressions, or nothing. One job at a time: the calls come in one order.
Traced traced(const std::string& inject, const std::string& more = "") {
    std::string command = "cd '" + work_folder().string() + "' && ASAN_OPTIONS=detect_leaks=0 strace -f -y -o trace -e trace=write,fsync,/^rename ";
    command += inject + " '" + RELIEFBAKE_BINARY + "' batch src --out out --jobs 1 --threads 1 " + more + " >stdout 2>stderr";
    const int status = shell_status(std::system(command.c_str()));
    // A run that is killed may leave half a line.
    std::string text = bytes_of(work_folder() / "stdout");
    text.resize(text.rfind('\n') == text.npos ? 0 : text.rfind('\n') + 1);
    return {status, bytes_of(work_folder() / "trace"), bytes_of(work_folder() / "stderr"), events_in(text)};
}

bool can_trace() {
    write_sources();
    if (traced("").trace.find("fsync") != std::string::npos) return true;
    WARN("SKIPPED: strace is missing or may not trace here: faults of a batch are not tested");
    return false;
}

/// How often the tool itself made this call (the helper writes no files), or "WHAT" in its line.
int count_calls(const std::string& trace, const std::string& call, const std::string& holds) {
    int calls = 0;
    std::istringstream lines(trace);
    for (std::string line; std::getline(lines, line);) calls += line.find(" " + call + "(") != line.npos && line.find(holds) != line.npos;
    return calls;
}

/// strace counts the calls of each name in each thread by itself: the number of the Nth call that holds `holds`, in its thread. The main
/// thread makes fewer of these before the end.
int number_in_thread(const std::string& trace, const std::string& call, const std::string& holds, int nth = 1) {
    std::map<std::string, int> calls;
    std::istringstream lines(trace);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t name = line.find_first_not_of("0123456789 ");
        if (name == line.npos || !line.substr(name).starts_with(call + "(")) continue;
        const int number = ++calls[line.substr(0, line.find(' '))];
        if (line.find(holds) != line.npos && --nth == 0) return number;
    }
    FAIL("no such call in the trace: " << call << " " << holds);
    return 0;
}

int strays() {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(out())) count += entry.path().filename().string().starts_with(".reliefbake-");
    return count;
}

/// The bytes that an undisturbed run writes.
const std::map<std::string, std::string>& undisturbed() {
    static const std::map<std::string, std::string> files = [] {
        write_sources();
        REQUIRE(batch("src --out out").status == 0);
        return files_below(out());
    }();
    return files;
}

/// What is there is whole, and a rerun mends all.
void check_resumed() {
    for (const auto& [name, bytes] : files_below(out()))
        if (name.find(".reliefbake-") == name.npos) CHECK(bytes == undisturbed().at(name));
    const BatchRun rerun = batch("src --out out");
    CHECK(rerun.status == 0);
    CHECK(rerun.err == "");
    CHECK(files_below(out()) == undisturbed());
    CHECK(strays() == 0);
    CHECK(batch("src --out out").ids("start").empty());
}

} // namespace

TEST_CASE("A full disk stops the batch with 74 and a name; nothing is half-written, and a rerun ends it") {
    if (!can_trace()) return;
    (void)undisturbed();
    write_sources();
    const Traced plain = traced("");
    REQUIRE(plain.status == 0);
    const struct {
        const char *call, *holds, *error;
        int nth;
    } faults[] = {{"write", ".reliefbake-", "ENOSPC", 2}, {"fsync", ".reliefbake-", "ENOSPC", 2}, {"rename", ".reliefbake-", "EIO", 2},
                  {"write", "ledger.jsonl", "ENOSPC", 2}, {"fsync", "ledger.jsonl", "EIO", 2}};
    for (const auto& fault : faults) {
        CAPTURE(fault.call, fault.holds, fault.error);
        write_sources();
        const int number = number_in_thread(plain.trace, fault.call, fault.holds, fault.nth);
        const Traced run = traced(std::string("-e inject=") + fault.call + ":error=" + fault.error + ":when=" + std::to_string(number));
        REQUIRE(run.fired("(INJECTED)"));
        CHECK(run.status == 74);
        CHECK(run.err.find("out/") != std::string::npos);
        CHECK(strays() == 0);
        REQUIRE_FALSE(run.events.empty());
        CHECK(run.events.back()["event"] == "summary");
        CHECK(run.events.back()["state"] == "stopped");
        check_resumed();
    }
}

TEST_CASE("An output that cannot be created fails alone, and is baked once it can") {
    (void)undisturbed();
    write_sources();
    fs::create_directories(out() / "map1_cone.png");
    const BatchRun run = batch("src --out out");
    CHECK(run.status == 3);
    CHECK(run.summary["failed"] == 1);
    CHECK(run.summary["baked"] == 4);
    CHECK(run.summary["failures"][0]["code"] == 73);
    fs::remove(out() / "map1_cone.png");
    check_resumed();
}

TEST_CASE("Killed at any call that writes: whole files, and a rerun that gives the undisturbed bytes") {
    if (!can_trace()) return;
    (void)undisturbed();
    write_sources();
    const Traced plain = traced("");
    // Every few of them here; tests/batch/kill_points.sh kills 200 times.
    const struct {
        const char *call, *holds;
    } steps[] = {{"write", ".reliefbake-"}, {"fsync", ".reliefbake-"}, {"rename", ".reliefbake-"}, {"fsync", "/out>"}, {"write", "ledger.jsonl"}, {"fsync", "ledger.jsonl"}};
    int round = 0;
    for (const auto& step : steps) {
        CAPTURE(step.call, step.holds);
        const int calls = count_calls(plain.trace, step.call, step.holds);
        REQUIRE(calls >= 5);
        const int nth = 1 + round++ * 3 % calls;
        write_sources();
        const Traced run = traced(std::string("-e inject=") + step.call + ":signal=SIGKILL:when=" + std::to_string(number_in_thread(plain.trace, step.call, step.holds, nth)));
        REQUIRE(run.fired("+++ killed by SIGKILL"));
        CHECK(run.status == 137);
        check_resumed();
    }
}

TEST_CASE("A signal ends a batch within two seconds: no temporaries, a summary, and the rest is baked later") {
    for (const int signal : {SIGINT, SIGTERM}) {
        CAPTURE(signal);
        const fs::path src = fresh_sources();
        for (int k = 0; k < 16; ++k) write_height(src / ("map" + std::to_string(k) + ".pgm"), k, 300 + k);
        RunningTool tool({"batch", "src", "--out", "out", "--jobs", "2"});
        while (tool.is_running() && files_below(out()).size() < 4) std::this_thread::sleep_for(5ms);
        REQUIRE(tool.is_running());
        const std::vector<pid_t> helpers = tool.children();
        CHECK(helpers.size() >= 2);
        tool.signal(signal);
        CHECK(tool.wait(2000ms) == 128 + signal);
        CHECK(strays() == 0);
        const nlohmann::json summary = nlohmann::json::parse(bytes_of(out() / ".reliefbake" / "summary.json"));
        CHECK(summary["state"] == "interrupted");
        CHECK(summary["failed"] == 0);
        CHECK(summary["not_started"] > 0);
        const std::size_t done = summary["baked"];
        const BatchRun rest = batch("src --out out");
        CHECK(rest.status == 0);
        CHECK(rest.summary["unchanged"] >= done);
        CHECK(rest.summary["baked"] > 0);
        CHECK(files_below(out()).size() == 16);
        const auto deadline = std::chrono::steady_clock::now() + 2000ms;
        for (const pid_t helper : helpers)
            while (is_alive(helper)) {
                REQUIRE(std::chrono::steady_clock::now() < deadline);
                std::this_thread::sleep_for(5ms);
            }
    }
}

TEST_CASE("A helper that is killed fails its asset for this run alone") {
    const fs::path src = fresh_sources();
    for (int k = 0; k < 8; ++k) write_height(src / ("map" + std::to_string(k) + ".pgm"), k, 400);
    RunningTool tool({"batch", "src", "--out", "out", "--jobs", "1"});
    bool killed = false;
    while (tool.is_running())
        for (const pid_t helper : tool.children()) {
            killed = kill(helper, SIGKILL) == 0 || killed;
            std::this_thread::sleep_for(100ms);
        }
    REQUIRE(killed);
    const int status = tool.wait(60000ms);
    CHECK((status == 0 || status == 3));
    const BatchRun rest = batch("src --out out");
    CHECK(rest.status == 0);
    CHECK(rest.summary["failed"] == 0);
    CHECK(files_below(out()).size() == 8);
}

TEST_CASE("A bar shows on a terminal alone, and is wiped off") {
    const fs::path src = fresh_sources();
    for (int k = 0; k < 8; ++k) write_height(src / ("map" + std::to_string(k) + ".pgm"), k, 500);
    RunningTool tool({"batch", "src", "--out", "out"}, RunningTool::Stderr::terminal);
    const std::string screen = tool.terminal_output();
    CHECK(tool.wait(2000ms) == 0);
    CHECK(screen.find("] 0 of 8") != screen.npos);
    CHECK(screen.find("texels/s") != screen.npos);
    CHECK(screen.ends_with("\r\033[K"));
    CHECK(batch("src --out out").err == "");
}

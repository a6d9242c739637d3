// Every step of writing a file fails, is interrupted, is killed: strace injects the fault, and each test sees that it did.

#include "tests/cli/run_tool.h"
#include "tests/cli/running_tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {

const std::string previous = "what was here before";

/// One call of the write: its name, and what its line in a trace holds.
struct Step {
    const char* call;
    const char* holds;
};
// A trace shows the beginning of a message: an encode request is the one that begins with its attributes.
constexpr Step encode_request{"sendmsg", "attributes"};
constexpr Step create_file{"openat", ".reliefbake-"}, write_file{"write", ".reliefbake-"}, sync_file{"fsync", ".reliefbake-"},
    close_file{"close", ".reliefbake-"}, publish{"rename", ".reliefbake-"}, sync_folder{"fsync", "/out>"};

fs::path out() { return work_folder() / "out"; }
fs::path target() { return out() / "map.png"; }

struct Traced {
    int status;
    std::string trace, err;
    int strays; ///< files beside the target
    std::string target;
};

/// Bakes over `previous` under strace; `inject` is an -e inject=... expression or empty.
Traced bake(const std::string& inject) {
    fs::remove_all(out());
    fs::create_directory(out());
    std::ofstream(target()) << previous;
    // LeakSanitizer cannot work under ptrace.
    std::string command = "cd '" + work_folder().string() + "' && ASAN_OPTIONS=detect_leaks=0 strace -y -o trace ";
    command += "-e trace=openat,write,fsync,close,sendmsg,/^rename " + inject + " '" + RELIEFBAKE_BINARY + "' cone ";
    command += height_map("gz_dem_squared_129.tif") + " -o out/map.png --quiet 2>stderr";
    const int status = shell_status(std::system(command.c_str()));
    int files = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(out()))
        ++files;
    return {status, bytes_of(work_folder() / "trace"), bytes_of(work_folder() / "stderr"), files - int(fs::exists(target())),
            bytes_of(target())};
}

/// The undisturbed run: its trace counts the calls before a step, its file is what every rerun must give. Empty where
/// strace cannot trace.
const Traced& undisturbed() {
    static const Traced traced = bake("");
    return traced;
}

bool can_trace() {
    if (undisturbed().trace.find("fsync") != std::string::npos) return true;
    WARN("SKIPPED: strace is missing or may not trace here: faults of the disk are not tested");
    return false;
}

/// "-e inject=CALL:FAULT:when=N" for the call that is the step.
std::string at(const Step& step, const std::string& fault) {
    std::istringstream lines(undisturbed().trace);
    int calls = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(step.call)) continue;
        ++calls;
        if (line.find(step.holds) == line.npos) continue;
        const std::string name = line.substr(0, line.find('('));
        return "-e inject=" + name + ":" + fault + ":when=" + std::to_string(calls);
    }
    FAIL("no such step in the trace: " << step.call << " " << step.holds);
    return "";
}

/// strace marks the call it has failed, and tells the signal it has sent.
bool fired(const Traced& run, const std::string& mark) { return run.trace.find(mark) != std::string::npos; }

} // namespace

TEST_CASE("A step that fails leaves the previous file, one line and nothing else") {
    if (!can_trace()) return;
    REQUIRE(undisturbed().status == 0);
    REQUIRE(undisturbed().target != previous);
    const struct {
        Step step;
        const char* error;
        int status;
    } faults[] = {{create_file, "ENOSPC", 74},     {create_file, "EACCES", 73},  {write_file, "ENOSPC", 74}, {write_file, "EIO", 74},
                  {sync_file, "ENOSPC", 74},  {sync_file, "EIO", 74},  {close_file, "EIO", 74}, {publish, "ENOSPC", 74},
                  {publish, "EIO", 74}};
    for (const auto& fault : faults) {
        CAPTURE(fault.step.call, fault.error);
        const Traced run = bake(at(fault.step, std::string("error=") + fault.error));
        REQUIRE(fired(run, "(INJECTED)"));
        CHECK(run.status == fault.status);
        CHECK(run.err.find("out/map.png") != std::string::npos);
        CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
        CHECK(run.target == previous);
        CHECK(run.strays == 0);
    }
}

TEST_CASE("A folder that cannot be synchronised is told; the file is whole") {
    if (!can_trace()) return;
    const Traced run = bake(at(sync_folder, "error=EIO"));
    REQUIRE(fired(run, "(INJECTED)"));
    CHECK(run.status == 74);
    CHECK(run.err.find("cannot be synchronised") != std::string::npos);
    CHECK(run.target == undisturbed().target);
    CHECK(run.strays == 0);
}

TEST_CASE("An interruption at any step leaves the previous file or the whole new one, and no temporary") {
    if (!can_trace()) return;
    for (const Step& step : {create_file, write_file, sync_file, close_file, publish, sync_folder, encode_request})
        for (const auto& [signal, status] : {std::pair("SIGINT", 130), std::pair("SIGTERM", 143)}) {
            CAPTURE(step.call, step.holds, signal);
            const Traced run = bake(at(step, std::string("signal=") + signal));
            REQUIRE(fired(run, std::string("--- ") + signal));
            CHECK(run.status == status);
            CHECK((run.target == previous || run.target == undisturbed().target));
            CHECK(run.strays == 0);
        }
}

TEST_CASE("Killed at any step: the previous file or the whole new one; a rerun gives the undisturbed bytes") {
    if (!can_trace()) return;
    for (const Step& step : {create_file, write_file, sync_file, close_file, publish, sync_folder}) {
        CAPTURE(step.call, step.holds);
        const Traced run = bake(at(step, "signal=SIGKILL"));
        REQUIRE(fired(run, "+++ killed by SIGKILL"));
        CHECK(run.status == 137);
        CHECK((run.target == previous || run.target == undisturbed().target));
        const Outcome rerun = run_tool("cone " + height_map("gz_dem_squared_129.tif") + " -o out/map.png --quiet");
        CHECK(rerun.status == 0);
        CHECK(bytes_of(target()) == undisturbed().target);
    }
}

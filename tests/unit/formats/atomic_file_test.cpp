#include "formats/atomic_file.h"

#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <vector>

using namespace reliefbake;
using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {
Result<void> write_text(const fs::path& path, const std::string& text) {
    return write_file_atomically(path, text);
}
} // namespace

TEST_CASE("a file appears whole and replaces whole") {
    TemporaryFolder folder;
    REQUIRE(write_text(folder / "a", "first"));
    CHECK(file_bytes(folder / "a") == "first");
    REQUIRE(write_text(folder / "a", "second, longer"));
    CHECK(file_bytes(folder / "a") == "second, longer");
    REQUIRE(write_text(folder / "empty", ""));
    CHECK(fs::file_size(folder / "empty") == 0);
    CHECK(folder.entries() == 2);
}

TEST_CASE("files of a batch appear together, or not at all") {
    TemporaryFolder folder;
    const std::string one = "one", two = "two";
    const auto bytes = [](const std::string& text) { return std::as_bytes(std::span(text)); };
    REQUIRE(write_text(folder / "a", "previous"));
    {
        FileBatch batch;
        REQUIRE(batch.add(folder / "a", bytes(one)));
        REQUIRE(batch.add(folder / "b", bytes(two)));
        CHECK(file_bytes(folder / "a") == "previous");
        CHECK_FALSE(fs::exists(folder / "b"));
        CHECK(batch.add(folder / "none" / "c", bytes(two)).error().code == ErrorCode::cannot_create);
    }
    CHECK(file_bytes(folder / "a") == "previous");
    CHECK(folder.entries() == 1); // the temporaries are gone
    FileBatch batch;
    REQUIRE(batch.add(folder / "a", bytes(one)));
    REQUIRE(batch.add(folder / "b", bytes(two)));
    REQUIRE(batch.publish());
    CHECK(file_bytes(folder / "a") == "one");
    CHECK(file_bytes(folder / "b") == "two");
    CHECK(folder.entries() == 2);
}

TEST_CASE("a symbolic link survives, other things are not replaced") {
    TemporaryFolder folder;
    fs::create_symlink("target", folder / "link");
    REQUIRE(write_text(folder / "link", "x"));
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(file_bytes(folder / "target") == "x");
    CHECK(write_text(folder.path(), "x").error().code == ErrorCode::cannot_create);
    CHECK(write_text("/dev/full", "x").error().code == ErrorCode::cannot_create);
}

TEST_CASE("what cannot be created is told by code and name") {
    TemporaryFolder folder;
    const Result<void> no_folder = write_text(folder / "none" / "a", "x");
    CHECK(no_folder.error().code == ErrorCode::cannot_create);
    CHECK(no_folder.error().message.starts_with((folder / "none" / "a").string() + ": "));
    const Result<void> read_only = write_text("/proc/a", "x");
    CHECK(read_only.error().code == ErrorCode::cannot_create);
}

TEST_CASE("a full disk leaves the previous file and nothing else") {
    TemporaryFolder folder;
    REQUIRE(write_text(folder / "a", "previous"));
    // A file-size limit stops write() half-way as a full disk does; unlike one, it needs no mount and hits no one else.
    rlimit saved{};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &saved) == 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = saved;
    small.rlim_cur = 100'000;
    REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
    const Result<void> full = write_text(folder / "a", std::string(1'000'000, 'x'));
    setrlimit(RLIMIT_FSIZE, &saved);
    std::signal(SIGXFSZ, handler);

    REQUIRE_FALSE(full); // the fault fired
    CHECK(full.error().code == ErrorCode::write_failed);
    CHECK(file_bytes(folder / "a") == "previous");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a signal in the middle of a write leaves nothing behind") {
    TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        // The limit's signal arrives inside write(): the temporary exists and is half written.
        std::signal(SIGXFSZ, [](int) {
            remove_temporaries_on_signal();
            _exit(42);
        });
        const rlimit small{1'000, 1'000};
        setrlimit(RLIMIT_FSIZE, &small);
        (void)write_text(folder / "a", std::string(5'000, 'x'));
        _exit(1);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    REQUIRE(WEXITSTATUS(status) == 42); // the fault fired
    CHECK(folder.entries() == 0);
}

TEST_CASE("many threads write at once, more than there are slots") {
    TemporaryFolder folder;
    std::vector<std::thread> threads;
    for (int i = 0; i < 100; ++i)
        threads.emplace_back([&, i] { (void)write_text(folder / std::to_string(i % 50), std::string(1000, char('a' + i % 50 % 26))); });
    for (std::thread& thread : threads) thread.join();
    CHECK(folder.entries() == 50);
    for (int i = 0; i < 50; ++i) CHECK(file_bytes(folder / std::to_string(i)) == std::string(1000, char('a' + i % 26)));
}

TEST_CASE("temporaries of runs that were killed are removed, and those of a running tool stay") {
    TemporaryFolder folder;
    fs::create_directories(folder / "sub");
    const pid_t gone = fork();
    if (gone == 0) _exit(0);
    waitpid(gone, nullptr, 0);
    const std::string dead = ".reliefbake-" + std::to_string(gone) + "-0.tmp";
    const std::string other = ".reliefbake-" + std::to_string(getpid()) + "-1.tmp"; // of a process that is not the tool
    for (const std::string& name : {dead, other, std::string("sub/") + dead, std::string(".reliefbake-x-0.tmp"), dead + "x", std::string("a.png")}) write_bytes(folder / name, "x");
    CHECK(remove_abandoned_temporaries(folder.path()).size() == 3);
    CHECK(folder.entries() == 4); // sub and three others
    CHECK(fs::is_empty(folder / "sub"));
    CHECK(remove_abandoned_temporaries(folder / "none").empty());
}

TEST_CASE("no temporary outlives a clean-up, however many writers are at work") {
    TemporaryFolder folder;
    for (int round = 0; round < 10; ++round) {
        const pid_t child = fork();
        if (child == 0) {
            std::vector<std::thread> writers;
            for (int k = 0; k < 8; ++k)
                writers.emplace_back([&, k] {
                    while (true) (void)write_text(folder / ("f" + std::to_string(k)), "x");
                });
            std::this_thread::sleep_for(std::chrono::milliseconds(20 + round));
            remove_temporaries_on_signal();
            _exit(0);
        }
        waitpid(child, nullptr, 0);
        CHECK(folder.entries() == 8); // each of the files, and nothing beside them
    }
}

#include "formats/journal.h"

#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

using namespace reliefbake;
using namespace reliefbake::test;
using Lines = std::vector<std::string>;

TEST_CASE("A journal grows by whole lines, and loses a torn one alone") {
    TemporaryFolder folder;
    const auto file = folder / "j";
    CHECK(Journal::read(file)->empty());
    {
        Result<Journal> journal = Journal::open(file);
        REQUIRE(journal);
        CHECK(journal->lines().empty());
        REQUIRE(journal->append("one"));
        REQUIRE(journal->append(""));
        REQUIRE(journal->append("three"));
    }
    CHECK(file_bytes(file) == "one\n\nthree\n");
    for (std::size_t size = 0; size <= 11; ++size) {
        write_bytes(file, std::string("one\n\nthree\n").substr(0, size));
        CHECK(Journal::read(file)->size() == (size >= 4) + (size >= 5) + std::size_t(size >= 11));
        Result<Journal> journal = Journal::open(file);
        REQUIRE(journal);
        REQUIRE(journal->append("next"));
        CHECK(Journal::read(file)->back() == "next");
        CHECK(Journal::read(file)->size() == journal->lines().size() + 1);
    }
}

TEST_CASE("A journal that is replaced is the old or the new one, and goes on") {
    TemporaryFolder folder;
    Result<Journal> journal = Journal::open(folder / "j");
    for (int k = 0; k < 5; ++k) REQUIRE(journal->append("old"));
    REQUIRE(journal->replace({"a", "b"}));
    REQUIRE(journal->append("c"));
    CHECK(*Journal::read(folder / "j") == Lines{"a", "b", "c"});
    CHECK(folder.entries() == 1);
}

TEST_CASE("A line that does not fit on the disk is told, and leaves no half of itself") {
    TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit few{100, 100};
        setrlimit(RLIMIT_FSIZE, &few);
        Result<Journal> journal = Journal::open(folder / "j");
        bool right = journal && journal->append(std::string(60, 'a'));
        const Result<void> full = journal->append(std::string(60, 'b'));
        right = right && !full && full.error().code == ErrorCode::write_failed && journal->append("c").has_value();
        _exit(right ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(status == 0);
    CHECK(*Journal::read(folder / "j") == Lines{std::string(60, 'a'), "c"});
}

TEST_CASE("A folder is held by one at a time, until its holder goes") {
    TemporaryFolder folder;
    {
        const auto first = FolderLock::take(folder / "lock");
        REQUIRE(first);
        CHECK(first->has_value());
        const auto second = FolderLock::take(folder / "lock");
        REQUIRE(second);
        CHECK_FALSE(second->has_value());
    }
    CHECK(FolderLock::take(folder / "lock")->has_value());
    CHECK(FolderLock::take(folder / "none" / "lock").error().code == ErrorCode::cannot_create);
}

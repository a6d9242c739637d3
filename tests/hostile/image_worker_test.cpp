// The helper process may be killed at any time: the next request works, and the one it died in says so.

#include "formats/image_worker.h"
#include "formats/map_file.h"
#include "formats/read_image.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>

using namespace reliefbake;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

const fs::path good = fs::path(RELIEFBAKE_TEST_DATA) / "hostile/edge_pngsuite_basi0g16.png";

ReliefMap noisy_map(int size) {
    ReliefMap map;
    map.grid = {size, size};
    unsigned state = 1;
    for (Image<float>* plane : {&map.normal_x, &map.normal_y, &map.cone, &map.depth}) {
        *plane = Image<float>(size, size);
        for (float& value : *plane) value = float((state = state * 1664525u + 1013904223u) >> 24) / 255.0f;
    }
    return map;
}

fs::path temporary(const char* name) { return fs::temp_directory_path() / (std::to_string(::getpid()) + name); }

std::string file_bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("the worker dies between requests: nobody notices") {
    REQUIRE(read_image(good, {}));
    const pid_t first = ImageWorker::instance().pid();
    REQUIRE(first > 0);
    REQUIRE(kill(first, SIGKILL) == 0);
    siginfo_t gone;
    REQUIRE(waitid(P_PID, id_t(first), &gone, WEXITED | WNOWAIT) == 0); // however busy the machine is; left for its owner to reap
    CHECK(read_image(good, {}));
    CHECK(ImageWorker::instance().pid() != first); // the fault fired
}

TEST_CASE("the worker dies in a request: that one fails in words, the next works, no file is left") {
    const ReliefMap map = noisy_map(2048);
    const fs::path path = temporary("-killed.png");
    REQUIRE(read_image(good, {}));
    const pid_t worker = ImageWorker::instance().pid();
    std::thread killer([&] {
        std::this_thread::sleep_for(150ms); // noise of 16 MB takes deflate a second
        kill(worker, SIGKILL);
    });
    const Result<void> written = write_map(path, map);
    killer.join();
    REQUIRE_FALSE(written); // the fault fired
    CHECK(written.error().code == ErrorCode::write_failed);
    CHECK(written.error().message.find("SIGKILL") != std::string::npos);
    CHECK_FALSE(fs::exists(path));
    CHECK(read_image(good, {}));
}

TEST_CASE("a reader that crashes is contained") {
    const fs::path crashes = fs::path(RELIEFBAKE_TEST_DATA) / "hostile/oiio_rowsperstrip-zero.exr";
    const Result<SourceImage> image = read_image(crashes, {});
    if (!image) CHECK(image.error().code == ErrorCode::bad_data);
    CHECK(read_image(good, {}));
}

TEST_CASE("many threads share the worker") {
    const std::string expected = read_image(good, {})->pixel_hash;
    std::atomic<int> right = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([&] {
            for (int k = 0; k < 10; ++k) {
                const Result<SourceImage> image = read_image(good, {});
                right += image && image->pixel_hash == expected;
            }
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(right == 80);
}

TEST_CASE("same map, same bytes: on another day, in another zone, another language, another process") {
    ReliefMap map = noisy_map(64);
    for (const char* name : {"-d.png", "-d.tif", "-d.tga", "-d.exr"}) {
        CAPTURE(name);
        map.info.bits = std::string(name) == "-d.exr" ? BitDepth::half : BitDepth::unorm8;
        const fs::path path = temporary(name);
        REQUIRE(write_map(path, map));
        const std::string first = file_bytes(path);
        setenv("TZ", "Asia/Kathmandu", 1);
        setenv("LC_ALL", "de_DE.UTF-8", 1);
        kill(ImageWorker::instance().pid(), SIGKILL);
        std::this_thread::sleep_for(1100ms); // a clock in the file would have moved on by a second
        REQUIRE(write_map(path, map));
        CHECK(file_bytes(path) == first);

        setenv("SOURCE_DATE_EPOCH", "86400", 1);
        REQUIRE(write_map(path, map));
        const bool carries_time = std::string(name) == "-d.tif" || std::string(name) == "-d.exr";
        CHECK((file_bytes(path).find("1970:01:02 00:00:00") != std::string::npos) == carries_time);
        unsetenv("SOURCE_DATE_EPOCH");
        unsetenv("TZ");
        unsetenv("LC_ALL");
        fs::remove(path);
    }
}

#include "cli/stage_clock.h"

#include <cstdio>
#include <unistd.h>

namespace reliefbake {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto quiet_time = std::chrono::seconds(1);
constexpr auto refresh_time = std::chrono::milliseconds(250);

} // namespace

ProgressLine::ProgressLine(bool enabled) {
    if (enabled && isatty(STDERR_FILENO)) thread_ = std::thread(&ProgressLine::show_until_stopped, this);
}

void ProgressLine::stop() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void ProgressLine::set_stage(const std::string& stage) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
}

void ProgressLine::show_until_stopped() {
    const auto start = Clock::now();
    std::unique_lock lock(mutex_);
    if (changed_.wait_for(lock, quiet_time, [this] { return stopped_; })) return;
    do {
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        std::fprintf(stderr, "\r\033[K%s %.0f s", stage_.c_str(), seconds);
        std::fflush(stderr);
    } while (!changed_.wait_for(lock, refresh_time, [this] { return stopped_; }));
    std::fputs("\r\033[K", stderr);
}

void StageClock::stop() {
    progress_.stop();
    add("total", std::chrono::duration<double>(Clock::now() - start_).count());
}

} // namespace reliefbake

#include "cli/stage_clock.h"

#include "cli/command_output.h"

#include <atomic>
#include <cstdio>
#include <string_view>
#include <unistd.h>

namespace reliefbake {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto quiet_time = std::chrono::seconds(1);
constexpr auto refresh_time = std::chrono::milliseconds(250);
constexpr std::string_view erase_line = "\r\033[K";

std::atomic<bool> line_shown = false;
static_assert(std::atomic<bool>::is_always_lock_free);

} // namespace

ProgressLine::ProgressLine(bool enabled) {
    if (enabled && !output_is_captured() && isatty(STDERR_FILENO)) thread_ = std::thread(&ProgressLine::show_until_stopped, this);
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
    line_shown = true;
    do {
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        std::fprintf(stderr, "%s%s %.0f s", erase_line.data(), stage_.c_str(), seconds);
        std::fflush(stderr);
    } while (!changed_.wait_for(lock, refresh_time, [this] { return stopped_; }));
    std::fputs(erase_line.data(), stderr);
    line_shown = false;
}

void erase_progress_on_signal() noexcept {
    if (line_shown) (void)!::write(STDERR_FILENO, erase_line.data(), erase_line.size());
}

void StageClock::stop() {
    progress_.stop();
    add("total", std::chrono::duration<double>(Clock::now() - start_).count());
}

} // namespace reliefbake

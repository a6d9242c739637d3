#pragma once
// Seconds per stage of a run, and a line on the terminal while a long one works.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace reliefbake {

/// Shows "stage 12 s" on stderr, rewritten in place, once the run is older than a second. Only on a terminal;
/// nothing is left on the line at the end.
class ProgressLine {
  public:
    explicit ProgressLine(bool enabled);
    ~ProgressLine() { stop(); }
    void stop();
    void set_stage(const std::string& stage);

  private:
    void show_until_stopped();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::string stage_;
    bool stopped_ = false;
    std::thread thread_;
};

/// Takes the line off the terminal if it is there; async-signal-safe.
void erase_progress_on_signal() noexcept;

class StageClock {
  public:
    using Seconds = std::vector<std::pair<std::string, double>>;

    explicit StageClock(bool show_progress) : progress_(show_progress) {}

    /// Takes the progress line away and adds the "total" since the clock was made, last.
    void stop();

    /// Runs work() as the named stage and returns what it returns.
    template <class Work>
    auto time(const std::string& stage, Work work) {
        progress_.set_stage(stage);
        const auto start = std::chrono::steady_clock::now();
        auto result = work();
        add(stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        return result;
    }

    /// Shows how far a stage is, until the next.
    void tell(const std::string& stage) { progress_.set_stage(stage); }

    /// Adds a stage measured elsewhere.
    void add(const std::string& stage, double seconds) { seconds_.emplace_back(stage, seconds); }

    /// In the order of the run.
    const Seconds& seconds() const { return seconds_; }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    ProgressLine progress_;
    Seconds seconds_;
};

} // namespace reliefbake

#pragma once
// What a batch tells while it works: a bar on a terminal, events for programs.

#include "cli/batch/batch_plan.h"
#include "cli/batch/bake_asset.h"
#include "cli/batch/summary.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <thread>

namespace reliefbake {

/// One line of JSON to stdout, at once. cli/schema/batch_event.schema.json has them all.
void print_event(const nlohmann::json& event);

/// What a run is about to do; `seconds` with one thread.
nlohmann::json plan_event(const BatchSummary& summary, std::size_t to_bake, double seconds);

struct ReportTo {
    bool bar = false;    ///< to stderr: share done, rate, time left
    bool events = false; ///< to stdout, one line of JSON each
    bool text = false;   ///< to stdout, for people, at the end
};

/// For any thread.
class BatchReporter {
  public:
    BatchReporter(BatchSummary summary, ReportTo to, std::filesystem::path summary_file);
    ~BatchReporter();
    BatchReporter(const BatchReporter&) = delete;
    BatchReporter& operator=(const BatchReporter&) = delete;

    /// Tells what will be done, and shows the bar from now on. `seconds`: predicted of all that will be baked, with one thread each.
    void begin(const BatchSummary& summary, std::size_t to_bake, double seconds);
    void started(const BatchJob& job, const std::string& reason, int threads);
    void finished(const BatchJob& job, const AssetResult& result);
    /// Nothing more will be started, for this reason; the first one counts.
    void stopping(const std::string& reason);

    /// Writes the summary's file and prints it. Errors: those of writing the file.
    Result<BatchSummary> conclude();
    /// The same from a run that ends now, whatever its other threads hold; gives up after half a second.
    void interrupted(int signal);

  private:
    Result<void> tell();
    void show_bar();
    std::string bar_text() const;
    void erase_bar();

    std::timed_mutex mutex_;
    BatchSummary summary_;
    const ReportTo to_;
    double predicted_ = 0, predicted_done_ = 0, texels_done_ = 0;
    std::set<std::string> running_;
    const std::filesystem::path summary_file_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::condition_variable_any changed_;
    bool closed_ = false, bar_shown_ = false;
    std::thread bar_;
};

} // namespace reliefbake

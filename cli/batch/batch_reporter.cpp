#include "cli/batch/batch_reporter.h"

#include "cli/report/format_text.h"
#include "formats/atomic_file.h"

#include <cstdio>

namespace reliefbake {

namespace {

using Clock = std::chrono::steady_clock;
using Lock = std::unique_lock<std::timed_mutex>;

constexpr auto refresh_time = std::chrono::milliseconds(250);
constexpr const char* erase_line = "\r\033[K";

} // namespace

void print_event(const nlohmann::json& event) {
    std::fputs((event.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n").c_str(), stdout);
    std::fflush(stdout);
}

nlohmann::json plan_event(const BatchSummary& summary, std::size_t to_bake, double seconds) {
    return {{"event", "plan"},       {"assets", summary.assets},   {"to_bake", to_bake},       {"skipped_files", summary.skipped_files},
            {"seconds_predicted", seconds / std::min(summary.threads, summary.jobs)}, {"jobs", summary.jobs}, {"threads", summary.threads}, {"memory", summary.memory}};
}

BatchReporter::BatchReporter(BatchSummary summary, ReportTo to, std::filesystem::path summary_file)
    : summary_(std::move(summary)), to_(to), summary_file_(std::move(summary_file)) {}

BatchReporter::~BatchReporter() {
    {
        const Lock lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
    if (bar_.joinable()) bar_.join();
}

void BatchReporter::begin(const BatchSummary& summary, std::size_t to_bake, double seconds) {
    const Lock lock(mutex_);
    summary_ = summary, predicted_ = seconds;
    if (to_.events) print_event(plan_event(summary, to_bake, seconds));
    if (to_.bar) bar_ = std::thread(&BatchReporter::show_bar, this);
}

void BatchReporter::started(const BatchJob& job, const std::string& reason, int threads) {
    const Lock lock(mutex_);
    running_.insert(job.id);
    if (to_.events)
        print_event({{"event", "start"}, {"id", job.id}, {"source", job.source}, {"kind", job.kind}, {"reason", reason}, {"threads", threads},
                     {"seconds_predicted", job.predicted.seconds}, {"bytes_predicted", job.predicted.bytes}});
}

void BatchReporter::finished(const BatchJob& job, const AssetResult& result) {
    const Lock lock(mutex_);
    running_.erase(job.id);
    predicted_done_ += job.predicted.seconds;
    texels_done_ += double(job.predicted.width) * double(job.predicted.height);
    if (!result.cache_fault.empty()) summary_.notes.push_back(result.cache_fault);
    if (result.error) summary_.failures.push_back({job.id, job.source, *result.error, false});
    else if (result.from_cache) ++summary_.from_cache;
    else ++summary_.baked;
    if (to_.events && result.error)
        print_event({{"event", "failed"}, {"id", job.id}, {"source", job.source}, {"kind", job.kind}, {"code", int(result.error->code)}, {"reason", result.error->message}});
    else if (to_.events)
        print_event({{"event", "done"}, {"id", job.id}, {"source", job.source}, {"kind", job.kind}, {"from_cache", result.from_cache}, {"seconds", result.line.seconds},
                     {"warnings", result.line.warnings}});
    else if (result.error) {
        erase_bar();
        std::fprintf(stderr, "reliefbake batch: %s\n", result.error->message.c_str());
    }
}

void BatchReporter::stopping(const std::string& reason) {
    const Lock lock(mutex_);
    if (summary_.state != "finished") return;
    summary_.state = "stopped";
    summary_.stopped_by = reason;
}

Result<void> BatchReporter::tell() {
    closed_ = true;
    erase_bar();
    summary_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const nlohmann::json summary = to_json(summary_);
    if (to_.events) {
        nlohmann::json event = summary;
        event["event"] = "summary";
        print_event(event);
    }
    if (to_.text) std::fputs(summary_text(summary_).c_str(), stdout);
    const std::string text = summary.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    return write_file_atomically(summary_file_, text);
}

Result<BatchSummary> BatchReporter::conclude() {
    const Lock lock(mutex_);
    return tell().map([&] { return summary_; });
}

void BatchReporter::interrupted(int signal) {
    const Lock lock(mutex_, std::chrono::milliseconds(500));
    if (!lock || closed_) return;
    summary_.state = "interrupted";
    summary_.stopped_by = "signal " + std::to_string(signal);
    (void)tell();
    std::fflush(stdout);
}

std::string BatchReporter::bar_text() const {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const double share = predicted_ > 0 ? std::min(1.0, predicted_done_ / predicted_) : 1;
    constexpr int width = 20;
    const int full = int(share * width);
    const std::size_t done = summary_.assets - summary_.not_started();
    std::string text = "[" + std::string(std::size_t(full), '=') + std::string(std::size_t(width - full), ' ') + format("] %zu of %zu", done, summary_.assets);
    if (!summary_.failures.empty()) text += format(", %zu failed", summary_.failures.size());
    text += format(", %.3g M texels/s", texels_done_ * 1e-6 / std::max(seconds, 1e-3));
    if (share > 0 && share < 1) text += format(", %.0f s left", seconds * (1 - share) / share);
    if (!running_.empty()) text += ", " + *running_.begin();
    constexpr std::size_t columns = 110; // a line that wraps could not be taken back
    return text.substr(0, columns);
}

void BatchReporter::show_bar() {
    Lock lock(mutex_);
    while (!closed_) {
        std::fprintf(stderr, "%s%s", erase_line, bar_text().c_str());
        std::fflush(stderr);
        bar_shown_ = true;
        changed_.wait_for(lock, refresh_time, [this] { return closed_; });
    }
    erase_bar();
}

void BatchReporter::erase_bar() {
    if (bar_shown_) std::fputs(erase_line, stderr);
    bar_shown_ = false;
}

} // namespace reliefbake

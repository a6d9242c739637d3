#include "cli/batch/batch_runner.h"

#include "cli/batch/bake_kinds.h"
#include "cli/report/format_text.h"
#include "formats/decode_session.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <list>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

namespace reliefbake {

namespace {

/// An asset taken off the queue, with what it holds until it is done.
struct Taken {
    AssetToBake asset;
    int threads;
    bool fits; ///< into the memory of the whole run
};

/// Who bakes what next, and with what.
class Queue {
  public:
    Queue(std::vector<AssetToBake> assets, const RunLimits& limits) : pending_(assets.begin(), assets.end()), limits_(limits) {
        pending_.sort([](const AssetToBake& a, const AssetToBake& b) { return a.job->predicted.seconds > b.job->predicted.seconds; }); // stable
        for (const AssetToBake& asset : pending_) seconds_left_ += asset.job->predicted.seconds;
    }

    /// Waits for memory. None: all are taken, or the run stops.
    std::optional<Taken> take() {
        std::unique_lock lock(mutex_);
        while (!stopped_ && !pending_.empty()) {
            const auto found = std::find_if(pending_.begin(), pending_.end(), [&](const AssetToBake& asset) {
                return !fits(*asset.job) || used_bytes_ + bytes_of(*asset.job) <= limits_.memory;
            });
            if (found == pending_.end()) {
                changed_.wait(lock);
                continue;
            }
            Taken taken{*found, threads_for(*found->job), fits(*found->job)};
            seconds_left_ -= found->job->predicted.seconds;
            pending_.erase(found);
            if (taken.fits) used_bytes_ += bytes_of(*taken.asset.job);
            used_threads_ += taken.threads;
            return taken;
        }
        return {};
    }

    void done(const Taken& taken) {
        {
            const std::lock_guard lock(mutex_);
            if (taken.fits) used_bytes_ -= bytes_of(*taken.asset.job);
            used_threads_ -= taken.threads;
        }
        changed_.notify_all();
    }

    void stop() {
        {
            const std::lock_guard lock(mutex_);
            stopped_ = true;
        }
        changed_.notify_all();
    }

  private:
    bool fits(const BatchJob& job) const { return job.predicted.bytes <= limits_.memory || can_stream(job); }
    /// One that is baked out of core has the whole ceiling for itself.
    std::uint64_t bytes_of(const BatchJob& job) const { return std::min(job.predicted.bytes, limits_.memory); }

    int threads_for(const BatchJob& job) const {
        const double share = seconds_left_ > 0 ? std::min(1.0, job.predicted.seconds / seconds_left_) : 1;
        return std::clamp(int(std::lround(limits_.threads * share)), 1, std::max(1, limits_.threads - used_threads_));
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::list<AssetToBake> pending_;
    const RunLimits& limits_;
    double seconds_left_ = 0;
    std::uint64_t used_bytes_ = 0;
    int used_threads_ = 0;
    bool stopped_ = false;
};

/// Headers may claim anything: what the decoder refuses takes no memory.
bool decoder_refuses(const BatchJob& job) { return !find_bake_kind(job.kind)->of_mesh && !DecodeSession::open(job.input, job.max_bytes, 1); }

AssetResult refuse_large(const BatchJob& job, const RunLimits& limits) {
    AssetResult result;
    constexpr double giga = 1e9;
    result.error = Error{ErrorCode::budget, job.input.string() + format(": is predicted to take %.3g GB, more than --memory, %.3g GB; raise it", double(job.predicted.bytes) / giga,
                                                                        double(limits.memory) / giga)};
    return result;
}

class Run {
  public:
    Run(const std::filesystem::path& out, const RunLimits& limits, const BakeCache* cache, Ledger& ledger, BatchReporter& reporter, Queue& queue)
        : out_(out), limits_(limits), cache_(cache), ledger_(ledger), reporter_(reporter), queue_(queue) {}

    void work() {
        const OwnImageWorker own;
        while (const std::optional<Taken> taken = queue_.take()) {
            const BatchJob& job = *taken->asset.job;
            reporter_.started(job, taken->asset.reason, taken->threads);
            const AssetResult result = taken->fits || decoder_refuses(job) ? bake(*taken) : refuse_large(job, limits_);
            if (!result.error || result.lasting)
                if (const Result<void> recorded = ledger_.record(result.line); !recorded) stop(recorded.error());
            if (result.error && result.error->code == ErrorCode::write_failed) stop(*result.error);
            if (result.error && limits_.fail_fast) {
                reporter_.stopping(job.id + " failed");
                queue_.stop();
            }
            reporter_.finished(job, result);
            queue_.done(*taken);
        }
    }

    Result<void> outcome() const {
        if (fatal_) return tl::unexpected(*fatal_);
        return {};
    }

  private:
    /// Whatever is thrown ends this asset alone.
    AssetResult bake(const Taken& taken) const {
        try {
            return bake_asset(*taken.asset.job, out_, taken.threads, limits_.memory, cache_);
        } catch (const std::bad_alloc&) {
            return {{}, Error{ErrorCode::budget, taken.asset.job->input.string() + ": out of memory"}, false, false, ""};
        } catch (const std::exception& error) {
            return {{}, Error{ErrorCode::internal, taken.asset.job->input.string() + ": internal fault: " + error.what()}, false, false, ""};
        }
    }

    void stop(const Error& error) {
        const std::lock_guard lock(mutex_);
        if (!fatal_) fatal_ = error;
        reporter_.stopping(error.message);
        queue_.stop();
    }

    const std::filesystem::path& out_;
    const RunLimits& limits_;
    const BakeCache* cache_;
    Ledger& ledger_;
    BatchReporter& reporter_;
    Queue& queue_;
    std::mutex mutex_;
    std::optional<Error> fatal_;
};

} // namespace

Result<void> run_assets(const std::vector<AssetToBake>& assets, const std::filesystem::path& out, const RunLimits& limits, const BakeCache* cache, Ledger& ledger,
                        BatchReporter& reporter) {
    Queue queue(assets, limits);
    Run run(out, limits, cache, ledger, reporter, queue);
    std::vector<std::thread> threads;
    const std::size_t count = std::min(assets.size(), std::size_t(limits.jobs));
    for (std::size_t k = 0; k < count; ++k) threads.emplace_back([&run] { run.work(); });
    for (std::thread& thread : threads) thread.join();
    return run.outcome();
}

} // namespace reliefbake

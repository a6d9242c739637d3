#include "cli/batch/batch.h"

#include "cli/batch/available_memory.h"
#include "cli/batch/batch_report.h"
#include "cli/batch/batch_state.h"
#include "cli/batch/exit_codes.h"
#include "cli/batch/interrupt.h"
#include "cli/options/thread_option.h"
#include "cli/output_checks.h"
#include "cli/report/format_text.h"
#include "formats/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <unistd.h>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

Result<void> make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (!error && ::access(folder.c_str(), W_OK | X_OK) == 0) return {};
    if (!error) error = std::error_code(errno, std::generic_category());
    return fail(error == std::errc::no_space_on_device ? ErrorCode::write_failed : ErrorCode::cannot_create, folder.string() + ": cannot write to the folder: " + error.message());
}

/// Better than any formula: how long it took last time.
void predict_from(const LedgerLines& known, BatchPlan& plan) {
    for (BatchJob& job : plan.jobs)
        if (const auto line = known.find(job.id); line != known.end() && line->second.seconds > 0) job.predicted.seconds = line->second.seconds;
}

const LedgerLine* line_of(const LedgerLines& known, const BatchJob& job) {
    const auto line = known.find(job.id);
    return line == known.end() ? nullptr : &line->second;
}

} // namespace

/// What is left to do, and what need not be done.
struct BatchCommand::Work {
    std::vector<AssetToBake> to_bake;
    std::vector<AssetFailure> failed_before;
    std::size_t unchanged = 0;
    double seconds = 0; ///< predicted, with one thread
};

void BatchCommand::add_to(CLI::App& app) {
    given_.add_to(app);
    app.add_option("--cache", cache_, "Folder of finished results, shared by any runs and machines")->type_name("DIR");
    app.add_flag("--retry-failed", retry_failed_, "Try again what was refused before, though nothing changed");
    app.option_defaults()->group("Run");
    if (sharded_) {
        CLI::Option* shard = app.add_option("--shard", shard_text_, "Which of N parts to bake, I from 0 (default: from SLURM_ARRAY_TASK_ID, or JOB_COMPLETION_INDEX and --shards)")->type_name("I/N");
        app.add_option("--shards", shards_, "Number of parts, where a scheduler says which")->check(CLI::Range(1, most_shards))->type_name("N")->excludes(shard);
    }
    CLI::Option* keep_going = app.add_flag("--keep-going", keep_going_, "Go on past an asset that fails (the default)");
    app.add_flag("--fail-fast", limits_.fail_fast, "Start nothing more once an asset has failed")->excludes(keep_going);
    app.add_flag("--dry-run", dry_run_, "Say what would be done, why, and how long it takes; write nothing");
    app.add_option("--jobs", limits_.jobs, "Files at once (default: as many as threads)")->check(CLI::Range(1, 1024))->type_name("N");
    add_thread_option(app, limits_.threads);
    app.add_option("--memory", limits_.memory, "Memory that the files at work may need together, e.g. 8GB (default: 3/4 of what is free)")->transform(CLI::AsSizeValue(false))->type_name("BYTES");
    CLI::Option* json = app.add_flag("--json", json_, "Events, a line of JSON each (cli/schema/batch_event.schema.json), on a terminal too");
    app.add_flag("--quiet", quiet_, "Print nothing unless something is wrong")->excludes(json);
    if (!sharded_)
        app.add_option("--report", page_, "Judge every asset shortly when all are baked, and show all on one page: thumbnails, verdicts worst first, failures, times")->type_name("HTML")->excludes("--dry-run");
}

Result<void> BatchCommand::resolve() {
    const Result<int> threads = resolve_threads(limits_.threads);
    if (!threads) return tl::unexpected(threads.error());
    limits_.threads = *threads;
    if (sharded_) {
        const Result<Shard> shard = find_shard(shard_text_, shards_);
        if (!shard) return tl::unexpected(shard.error());
        shard_ = *shard;
    }
    if (limits_.jobs == 0) limits_.jobs = *threads;
    if (limits_.memory == 0) limits_.memory = available_memory() / 4 * 3;
    report_.events = !quiet_ && (json_ || !::isatty(STDOUT_FILENO));
    report_.text = !quiet_ && !report_.events;
    report_.bar = !quiet_ && !dry_run_ && ::isatty(STDERR_FILENO);
    return {};
}

Result<BatchPlan> BatchCommand::plan() const {
    Result<BatchPlan> planned = given_.plan();
    if (planned && sharded_) keep_shard(*planned, shard_);
    return planned;
}

fs::path BatchCommand::state() const { return sharded_ ? shard_folder(state_folder(given_.out), shard_) : state_folder(given_.out); }

Result<LedgerLines> BatchCommand::known_lines() const {
    Result<LedgerLines> lines = Ledger::read(ledger_file(state_folder(given_.out)));
    if (!lines || !sharded_) return lines;
    const Result<LedgerLines> own = Ledger::read(ledger_file(state()));
    if (!own) return tl::unexpected(own.error());
    for (const auto& [id, line] : *own) lines->insert_or_assign(id, line);
    return lines;
}

Result<void> BatchCommand::run() {
    if (Result<void> resolved = resolve(); !resolved) return resolved;
    Result<BatchPlan> planned = plan();
    if (!planned) return tl::unexpected(planned.error());
    if (!page_.empty())
        if (Result<void> apart = check_page(*planned); !apart) return apart;
    if (dry_run_) {
        const Result<LedgerLines> known = known_lines();
        if (!known) return tl::unexpected(known.error());
        predict_from(*known, *planned);
        return tell_plan(*planned, *known);
    }
    return bake(*planned);
}

Result<void> BatchCommand::tell_plan(const BatchPlan& plan, const LedgerLines& known) const {
    double seconds = 0;
    std::size_t to_bake = 0;
    for (const BatchJob& job : plan.jobs) {
        const Freshness verdict = judge(job, line_of(known, job), plan.out, retry_failed_);
        if (verdict.must_bake) seconds += job.predicted.seconds, ++to_bake;
        const std::string reason = verdict.must_bake ? verdict.reason : verdict.failed_before ? "failed before, and nothing changed" : "nothing changed";
        if (report_.events)
            print_event({{"event", "planned"}, {"id", job.id}, {"source", job.source}, {"kind", job.kind}, {"rule", job.rule}, {"bake", verdict.must_bake}, {"reason", reason},
                         {"width", job.predicted.width}, {"height", job.predicted.height}, {"seconds_predicted", job.predicted.seconds}, {"bytes_predicted", job.predicted.bytes}});
        else if (report_.text)
            std::printf("%s %s -> %s (%s; %s), %.2g s\n", verdict.must_bake ? "bake " : "leave", job.source.c_str(), job.id.c_str(), job.rule.c_str(), reason.c_str(),
                        verdict.must_bake ? job.predicted.seconds : 0);
    }
    for (const SkippedFile& file : plan.skipped) {
        if (report_.events) print_event({{"event", "skipped"}, {"source", file.source}, {"reason", file.reason}});
        else if (report_.text) std::printf("skip  %s (%s)\n", file.source.c_str(), file.reason.c_str());
    }
    const nlohmann::json event = plan_event(beginning(plan), to_bake, seconds);
    if (report_.events) print_event(event);
    else if (report_.text) std::printf("%zu assets, %zu to bake, about %.2g s\n", plan.jobs.size(), to_bake, event["seconds_predicted"].get<double>());
    return {};
}

Result<BatchCommand::Work> BatchCommand::find_work(const BatchPlan& plan, const LedgerLines& known, Ledger& ledger) const {
    Work work;
    for (const BatchJob& job : plan.jobs) {
        Freshness verdict = judge(job, line_of(known, job), plan.out, retry_failed_);
        if (verdict.renewed)
            if (Result<void> recorded = ledger.record(*verdict.renewed); !recorded) return tl::unexpected(recorded.error());
        if (verdict.must_bake) {
            work.to_bake.push_back({&job, verdict.reason});
            work.seconds += job.predicted.seconds;
        } else if (verdict.failed_before) {
            work.failed_before.push_back({job.id, job.source, *line_of(known, job)->failure, true});
        } else {
            ++work.unchanged;
        }
    }
    return work;
}

BatchSummary BatchCommand::beginning(const BatchPlan& plan) const {
    BatchSummary summary;
    summary.assets = plan.jobs.size(), summary.skipped_files = plan.skipped.size();
    summary.jobs = limits_.jobs, summary.threads = limits_.threads, summary.memory = limits_.memory;
    return summary;
}

Result<void> BatchCommand::bake_left(BatchPlan& plan, BatchSummary summary, Ledger& ledger, BatchReporter& reporter) const {
    const InterruptWatch watch([&](int signal) { reporter.interrupted(signal); });
    const Result<LedgerLines> known = known_lines();
    if (!known) return tl::unexpected(known.error());
    predict_from(*known, plan);
    const Result<Work> work = find_work(plan, *known, ledger);
    if (!work) return tl::unexpected(work.error());
    summary.unchanged = work->unchanged;
    summary.failures = work->failed_before;
    reporter.begin(summary, work->to_bake.size(), work->seconds);
    const BakeCache cache(cache_);
    return run_assets(work->to_bake, plan.out, limits_, cache_.empty() ? nullptr : &cache, ledger, reporter);
}

Result<void> BatchCommand::check_page(const BatchPlan& plan) const {
    if (Result<void> folder = validate_output_folder(page_); !folder) return folder;
    for (const BatchJob& job : plan.jobs) {
        std::vector<fs::path> files = job.inputs;
        for (const std::string& output : job.outputs) files.push_back(plan.out / output);
        for (const fs::path& file : files)
            if (identity_of(file) == identity_of(page_)) return fail(ErrorCode::usage, "--report " + page_ + ": is a file of " + job.source + "; name another");
    }
    return {};
}

Result<void> BatchCommand::write_page(const BatchPlan& plan, const BatchSummary& summary) const {
    const Result<LedgerLines> lines = known_lines();
    if (!lines) return tl::unexpected(lines.error());
    const std::string page = report_batch(plan, *lines, summary, limits_.threads);
    return write_file_atomically(page_, page);
}

Result<void> BatchCommand::bake(BatchPlan& plan) const {
    // Hold the folder; shards hold it together, and each its own part.
    const fs::path whole = state_folder(plan.out);
    for (const fs::path& folder : {whole, plan.out, state()})
        if (Result<void> made = make_folder(folder); !made) return made;
    const Result<std::optional<FolderLock>> lock = FolderLock::take(whole / "lock", sharded_ ? FolderLock::Hold::together : FolderLock::Hold::alone);
    if (!lock) return tl::unexpected(lock.error());
    if (!*lock) return fail(folder_is_busy, plan.out.string() + ": another run holds the folder; wait for its end or choose another --out");
    Result<std::optional<FolderLock>> own = std::optional<FolderLock>();
    if (sharded_) {
        own = FolderLock::take(state() / "lock", FolderLock::Hold::alone);
        if (!own) return tl::unexpected(own.error());
        if (!*own) return fail(folder_is_busy, state().string() + ": another run bakes this shard");
    }
    Result<Ledger> ledger = Ledger::open(ledger_file(state()));
    if (!ledger) return tl::unexpected(ledger.error());

    BatchSummary summary = beginning(plan);
    std::error_code ignored;
    if (sharded_) fs::remove(summary_file(state()), ignored); // `merge` must not take the last run's for this one's
    if (!sharded_) // else they may be those of another machine
        for (const fs::path& file : remove_abandoned_temporaries(plan.out)) summary.notes.push_back("removed " + file.string() + ", left by a run that was killed");
    BatchReporter reporter(summary, report_, summary_file(state()));
    const Result<void> ran = bake_left(plan, summary, *ledger, reporter);
    const Result<BatchSummary> end = reporter.conclude();
    if (!ran) return ran;
    if (!end) return tl::unexpected(end.error());
    if (!page_.empty())
        if (Result<void> written = write_page(plan, *end); !written) return written;
    if (end->failures.empty()) return {};
    return fail(partial_failure, format("%zu of %zu assets failed; ", end->failures.size(), end->assets) + summary_file(state()).string() + " names them");
}

} // namespace reliefbake

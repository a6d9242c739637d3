#include "cli/merge/merge_shards.h"

#include "cli/batch/batch_state.h"
#include "cli/batch/exit_codes.h"
#include "cli/batch/ledger.h"
#include "cli/batch/shard.h"
#include "formats/atomic_file.h"
#include "formats/journal.h"
#include "formats/whole_file.h"

#include <algorithm>
#include <map>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t longest_summary = 1u << 30;

/// Shards by their number, of each N that there is.
std::map<int, std::map<int, fs::path>> find_shards(const fs::path& state) {
    std::map<int, std::map<int, fs::path>> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(state / "shards", ignored))
        if (const std::optional<Shard> shard = shard_of_folder(entry.path().filename().string())) found[shard->count][shard->index] = entry.path();
    return found;
}

/// What a shard said at its end. Errors: no_input (it has not ended), bad_data.
Result<BatchSummary> read_summary(const fs::path& folder, const std::string& name) {
    const fs::path file = summary_file(folder);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return fail(ErrorCode::no_input, folder.string() + ": " + name + " has not run to its end; run it again, then merge");
    const Result<std::string> text = read_whole_file(file, longest_summary);
    if (!text) return tl::unexpected(text.error());
    Result<BatchSummary> summary = summary_from(nlohmann::json::parse(*text, nullptr, false));
    if (!summary) return fail(ErrorCode::bad_data, file.string() + ": " + summary.error().message);
    if (summary->state != "finished")
        return fail(ErrorCode::no_input, folder.string() + ": " + name + " was " + summary->state + " (" + summary->stopped_by + "); run it again, then merge");
    return summary;
}

void add(BatchSummary& sum, const BatchSummary& shard) {
    sum.assets += shard.assets, sum.baked += shard.baked, sum.from_cache += shard.from_cache, sum.unchanged += shard.unchanged;
    sum.skipped_files = shard.skipped_files; // each shard sees all files
    sum.failures.insert(sum.failures.end(), shard.failures.begin(), shard.failures.end());
    sum.seconds = std::max(sum.seconds, shard.seconds);
    sum.jobs += shard.jobs, sum.threads += shard.threads, sum.memory += shard.memory;
    sum.notes.insert(sum.notes.end(), shard.notes.begin(), shard.notes.end());
}

} // namespace

Result<BatchSummary> merge_shards(const fs::path& out) {
    const fs::path state = state_folder(out);
    std::error_code error;
    if (!fs::is_directory(state / "shards", error)) return fail(ErrorCode::no_input, state.string() + ": there are no shards to merge; `reliefbake run --shard I/N` makes them");
    const Result<std::optional<FolderLock>> lock = FolderLock::take(state / "lock");
    if (!lock) return tl::unexpected(lock.error());
    if (!*lock) return fail(folder_is_busy, out.string() + ": a run is at work in the folder; wait for its end");

    const std::map<int, std::map<int, fs::path>> shards = find_shards(state);
    if (shards.empty()) return fail(ErrorCode::no_input, state.string() + ": there are no shards to merge; `reliefbake run --shard I/N` makes them");
    BatchSummary sum;
    LedgerLines lines;
    for (const auto& [count, folders] : shards)
        for (int index = 0; index < count; ++index) {
            const std::string name = "shard " + std::to_string(index) + "/" + std::to_string(count);
            const auto folder = folders.find(index);
            if (folder == folders.end()) return fail(ErrorCode::no_input, out.string() + ": " + name + " has not been run; run it, then merge");
            const Result<BatchSummary> summary = read_summary(folder->second, name);
            if (!summary) return tl::unexpected(summary.error());
            add(sum, *summary);
            const Result<LedgerLines> own = Ledger::read(ledger_file(folder->second));
            if (!own) return tl::unexpected(own.error());
            for (const auto& [id, line] : *own) lines.insert_or_assign(id, line);
        }
    std::sort(sum.failures.begin(), sum.failures.end(), [](const AssetFailure& a, const AssetFailure& b) { return a.id < b.id; });

    // First the ledger, then the summary; shards go last, so that a merge that was killed can be done again.
    Result<Ledger> ledger = Ledger::open(ledger_file(state));
    if (!ledger) return tl::unexpected(ledger.error());
    for (const auto& [id, line] : lines)
        if (Result<void> recorded = ledger->record(line); !recorded) return tl::unexpected(recorded.error());
    for (const fs::path& file : remove_abandoned_temporaries(out)) sum.notes.push_back("removed " + file.string() + ", left by a run that was killed");
    const std::string text = to_json(sum).dump(2) + "\n";
    if (Result<void> written = write_file_atomically(summary_file(state), text); !written) return tl::unexpected(written.error());
    fs::remove_all(state / "shards", error);
    return sum;
}

} // namespace reliefbake

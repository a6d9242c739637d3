#include "cli/batch/freshness.h"

#include "cli/batch/algorithm_version.h"
#include "cli/batch/bake_kinds.h"

#include <chrono>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

/// A file that changed just now may change again within the same tick of the file system's clock (up to 10 ms on Linux), unseen: its
/// stamp is made one that no file has, so that the next run looks at the bytes.
FileStamp trusted(const FileStamp& stamp) {
    constexpr std::int64_t tick = 20'000'000;
    const std::int64_t now = std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
    return std::max(stamp.changed, stamp.modified) + tick < now ? stamp : FileStamp();
}

Freshness bake_because(const std::string& reason) { return {true, reason, false, {}}; }

/// The line with the inputs as they are now; none where they decode to something else, with the reason.
std::optional<LedgerLine> same_inputs(const BatchJob& job, const LedgerLine& line, std::string& reason) {
    LedgerLine now = line;
    if (line.inputs.size() != job.inputs.size()) {
        reason = "other input files";
        return {};
    }
    bool stamps = true;
    for (std::size_t k = 0; k < job.inputs.size(); ++k) stamps = stamps && stamp_of(job.inputs[k]) == std::optional(line.inputs[k].stamp);
    if (stamps) return now;
    const Result<std::vector<FileRecord>> files = identify_inputs(job);
    if (!files) {
        reason = files.error().message;
        return {};
    }
    bool bytes = true;
    for (std::size_t k = 0; k < files->size(); ++k) bytes = bytes && (*files)[k].hash == line.inputs[k].hash;
    now.inputs = *files;
    if (bytes || decoded_hash(job, *files) == line.decoded) return now;
    reason = "its input changed";
    return {};
}

/// Whether all outputs are there as they were written; renews stamps.
bool same_outputs(LedgerLine& line, const fs::path& out, std::string& reason) {
    for (FileRecord& file : line.outputs) {
        const std::optional<FileStamp> stamp = stamp_of(out / file.name);
        if (!stamp) {
            reason = file.name + " vanished";
            return false;
        }
        if (*stamp == file.stamp) continue;
        const Result<std::string> hash = hash_of_bytes(out / file.name);
        if (!hash || *hash != file.hash) {
            reason = file.name + " was edited";
            return false;
        }
        file.stamp = *stamp;
    }
    return true;
}

bool same_stamps(const std::vector<FileRecord>& a, const std::vector<FileRecord>& b) {
    for (std::size_t k = 0; k < a.size(); ++k)
        if (!(a[k].stamp == b[k].stamp)) return false;
    return true;
}

} // namespace

Result<std::vector<FileRecord>> identify_inputs(const BatchJob& job) {
    std::vector<FileRecord> files;
    for (const fs::path& path : job.inputs) {
        const std::optional<FileStamp> stamp = stamp_of(path);
        if (!stamp) return fail(ErrorCode::no_input, path.string() + ": is not there, or no regular file");
        const Result<std::string> hash = hash_of_bytes(path);
        if (!hash) return tl::unexpected(hash.error());
        files.push_back({path.filename().string(), trusted(*stamp), *hash});
    }
    return files;
}

std::string decoded_hash(const BatchJob& job, const std::vector<FileRecord>& inputs) {
    std::string text;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        Result<std::string> decoded = fail(ErrorCode::bad_data, "");
        if (!find_bake_kind(job.kind)->of_mesh) decoded = hash_of_image(job.inputs[k], job.max_bytes);
        text += decoded ? "image " + *decoded + "\n" : "bytes " + inputs[k].hash + "\n";
    }
    return hash_of_text(text);
}

Freshness judge(const BatchJob& job, const LedgerLine* line, const fs::path& out, bool retry_failed) {
    if (!line) return bake_because("new");
    if (line->algorithm != algorithm_version()) return bake_because("baked by version " + line->algorithm);
    if (line->kind != job.kind || line->arguments != hash_of_text(job.arguments)) return bake_because("its options changed");
    if (line->failure && retry_failed) return bake_because("failed before");
    std::string reason;
    std::optional<LedgerLine> now = same_inputs(job, *line, reason);
    if (!now || !same_outputs(*now, out, reason)) return bake_because(reason);
    Freshness fresh{false, "", line->failure.has_value(), {}};
    if (!same_stamps(now->inputs, line->inputs) || !same_stamps(now->outputs, line->outputs)) fresh.renewed = std::move(now);
    return fresh;
}

} // namespace reliefbake

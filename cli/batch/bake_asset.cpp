#include "cli/batch/bake_asset.h"

#include "cli/batch/algorithm_version.h"
#include "cli/batch/freshness.h"
#include "cli/batch/run_command.h"
#include "formats/image_worker.h"

#include <chrono>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

std::vector<std::optional<FileStamp>> stamps_of(const BatchJob& job) {
    std::vector<std::optional<FileStamp>> stamps;
    for (const fs::path& path : job.inputs) stamps.push_back(stamp_of(path));
    return stamps;
}

Result<void> make_folders(const BatchJob& job, const fs::path& out) {
    for (const std::string& output : job.outputs) {
        const fs::path folder = (out / output).parent_path();
        std::error_code error;
        fs::create_directories(folder, error);
        if (!error) continue;
        const bool full = error == std::errc::no_space_on_device;
        return fail(full ? ErrorCode::write_failed : ErrorCode::cannot_create, folder.string() + ": cannot create the folder: " + error.message());
    }
    return {};
}

/// The statistics that the command printed, and the size of the map.
nlohmann::json statistics_of(const std::string& text) {
    nlohmann::json kept = nlohmann::json::object();
    const nlohmann::json result = nlohmann::json::parse(text, nullptr, false);
    if (!result.is_object()) return kept;
    if (const auto statistics = result.find("statistics"); statistics != result.end()) kept = *statistics;
    for (const char* key : {"width", "height"})
        if (const auto map = result.find("map"); map != result.end() && map->is_object() && map->contains(key)) kept[key] = (*map)[key];
    return kept;
}

Result<void> bake(const BatchJob& job, const fs::path& out, int threads, std::uint64_t memory, LedgerLine& line) {
    std::vector<std::string> words = command_line(job, out, threads);
    // Out of core only what does not fit: the rest was admitted by its prediction, and cone's own, higher estimate must not refuse it.
    constexpr std::uint64_t any = std::uint64_t(1) << 50;
    const std::uint64_t ceiling = can_stream(job) && job.predicted.bytes > memory ? memory : any;
    if (takes_memory(job)) words.insert(words.end(), {"--memory", std::to_string(ceiling)});
    const auto start = std::chrono::steady_clock::now();
    Result<CommandResult> result = run_command(words);
    if (!result) return tl::unexpected(result.error());
    line.seconds = threads * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    line.warnings = std::move(result->warnings);
    line.statistics = statistics_of(result->json);
    for (const std::string& name : job.outputs) {
        const std::optional<FileStamp> stamp = stamp_of(out / name);
        if (!stamp) continue; // a mip level that this map is too small for
        const Result<std::string> hash = hash_of_bytes(out / name);
        if (!hash) return tl::unexpected(hash.error());
        line.outputs.push_back({name, *stamp, *hash});
    }
    if (line.outputs.empty() || line.outputs.front().name != job.id) return fail(ErrorCode::internal, job.id + ": was baked, and is not there");
    return {};
}

/// Whether another run would meet the same failure.
bool lasts(const Error& error) { return error.code == ErrorCode::bad_data || error.code == ErrorCode::usage; }

} // namespace

AssetResult bake_asset(const BatchJob& job, const fs::path& out, int threads, std::uint64_t memory, const BakeCache* cache) {
    AssetResult result;
    LedgerLine& line = result.line;
    line.id = job.id, line.source = job.source, line.kind = job.kind;
    line.arguments = hash_of_text(job.arguments), line.algorithm = algorithm_version();
    const auto failed = [&](const Error& error, bool lasting) {
        result.error = error, result.lasting = lasting;
        line.failure = error, line.outputs.clear();
        return result;
    };

    // Identify first: the line must tell of nothing newer than what is baked.
    const std::vector<std::optional<FileStamp>> before = stamps_of(job);
    (void)ImageWorker::instance().take_killed();
    Result<std::vector<FileRecord>> inputs = identify_inputs(job);
    if (!inputs) return failed(inputs.error(), false);
    line.inputs = std::move(*inputs);
    line.decoded = decoded_hash(job, line.inputs);
    if (Result<void> made = make_folders(job, out); !made) return failed(made.error(), false);

    Result<bool> fetched = cache ? cache->fetch(job, out, line) : Result<bool>(false);
    if (!fetched) return failed(fetched.error(), false);
    result.from_cache = *fetched;
    const Result<void> baked = *fetched ? Result<void>() : bake(job, out, threads, memory, line);
    if (stamps_of(job) != before) return failed({ErrorCode::bad_data, job.input.string() + ": changed while it was baked; run again"}, false);
    const bool killed = ImageWorker::instance().take_killed();
    if (!baked && killed) return failed({ErrorCode::internal, baked.error().message}, false);
    if (!baked) return failed(baked.error(), lasts(baked.error()));
    if (cache && !*fetched)
        if (const Result<void> stored = cache->store(job, out, line); !stored) result.cache_fault = stored.error().message;
    return result;
}

} // namespace reliefbake

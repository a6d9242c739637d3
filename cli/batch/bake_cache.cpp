#include "cli/batch/bake_cache.h"

#include "formats/atomic_file.h"
#include "formats/whole_file.h"

#include <span>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uint64_t largest_entry = 1u << 20;
constexpr std::uint64_t boundless = ~std::uint64_t(0);

/// What an output adds to the name of the first one: extension, "_b", "_mip1", or its own name where it is called otherwise.
std::string role_of(const BatchJob& job, const std::string& output) {
    const fs::path first = job.id, file = output;
    const std::string stem = first.stem().string(), name = file.filename().string();
    return name.starts_with(stem) ? name.substr(stem.size()) : "#" + file.extension().string();
}

/// Equal for bakes of equal bytes into equal formats, wherever they lie and however they are called.
std::string key_of(const BatchJob& job, const LedgerLine& line) {
    std::string text = line.algorithm + "\n" + line.kind + "\n" + line.arguments + "\n" + line.decoded + "\n";
    for (const std::string& output : job.outputs) text += role_of(job, output) + "\n";
    return hash_of_text(text);
}

Result<void> write(const fs::path& path, const std::string& bytes) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) return fail(ErrorCode::cannot_create, path.parent_path().string() + ": cannot create the folder: " + error.message());
    return write_file_atomically(path, bytes);
}

struct CachedFile {
    std::size_t output; ///< index in BatchJob::outputs
    std::string bytes;
};

} // namespace

fs::path BakeCache::file_for(const std::string& hash, const char* extension) const { return folder_ / hash.substr(0, 2) / (hash + extension); }

Result<bool> BakeCache::fetch(const BatchJob& job, const fs::path& out, LedgerLine& line) const {
    const Result<std::string> text = read_whole_file(file_for(key_of(job, line), ".json"), largest_entry);
    const json entry = text ? json::parse(*text, nullptr, false) : json();
    if (!entry.is_object()) return false;
    std::vector<CachedFile> files;
    try {
        for (const json& file : entry.at("files")) {
            const std::size_t output = file.at("output").get<std::size_t>();
            const std::string hash = file.at("hash").get<std::string>();
            if (output >= job.outputs.size() || hash.size() != 32 || hash.find_first_not_of("0123456789abcdef") != hash.npos) return false;
            Result<std::string> bytes = read_whole_file(file_for(hash, ".bin"), boundless);
            if (!bytes || hash_of_text(*bytes) != hash) return false;
            files.push_back({output, std::move(*bytes)});
        }
        line.seconds = entry.at("seconds").get<double>();
        line.warnings = entry.at("warnings").get<std::vector<std::string>>();
        line.statistics = entry.at("statistics");
    } catch (const json::exception&) { // damaged: none of ours
        return false;
    }
    if (files.empty()) return false;
    FileBatch batch;
    for (const CachedFile& file : files)
        if (Result<void> added = batch.add(out / job.outputs[file.output], std::as_bytes(std::span(file.bytes))); !added) return tl::unexpected(added.error());
    if (Result<void> published = batch.publish(); !published) return tl::unexpected(published.error());
    for (const CachedFile& file : files) {
        const std::string& name = job.outputs[file.output];
        line.outputs.push_back({name, stamp_of(out / name).value_or(FileStamp()), hash_of_text(file.bytes)});
    }
    return true;
}

Result<void> BakeCache::store(const BatchJob& job, const fs::path& out, const LedgerLine& line) const {
    json entry = {{"files", json::array()}, {"seconds", line.seconds}, {"warnings", line.warnings}, {"statistics", line.statistics}};
    for (const FileRecord& file : line.outputs) {
        std::size_t output = 0;
        while (output < job.outputs.size() && job.outputs[output] != file.name) ++output;
        entry["files"].push_back({{"output", output}, {"hash", file.hash}});
        const fs::path blob = file_for(file.hash, ".bin");
        std::error_code ignored;
        if (fs::exists(blob, ignored) && hash_of_bytes(blob).value_or("") == file.hash) continue;
        const Result<std::string> bytes = read_whole_file(out / file.name, boundless);
        if (!bytes) return tl::unexpected(bytes.error());
        if (Result<void> written = write(blob, *bytes); !written) return written;
    }
    return write(file_for(key_of(job, line), ".json"), entry.dump(-1, ' ', false, json::error_handler_t::replace));
}

} // namespace reliefbake

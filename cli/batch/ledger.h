#pragma once
// What has been baked: one line of JSON an asset, which is its commit record. docs/BATCH.md describes the keys.

#include "bake/error.h"
#include "formats/file_identity.h"
#include "formats/journal.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

struct FileRecord {
    std::string name; ///< an output: relative to the output folder; an input: for people
    FileStamp stamp;  ///< when the bytes were hashed
    std::string hash; ///< of the bytes
};

struct LedgerLine {
    std::string id, source, kind;
    std::string arguments; ///< hash of the canonical options
    std::string algorithm; ///< algorithm_version
    std::string decoded;   ///< hash of what the inputs decode to
    std::vector<FileRecord> inputs, outputs;
    std::optional<Error> failure; ///< the refusal of this input, which another run would meet again
    double seconds = 0;           ///< of the bake, times its threads
    std::vector<std::string> warnings;
    nlohmann::json statistics = nlohmann::json::object(); ///< of the map, as --json tells them
};

/// One line without its end.
std::string to_line(const LedgerLine& line);

/// None where the text is no such line, or one of a later version.
std::optional<LedgerLine> from_line(const std::string& text);

using LedgerLines = std::map<std::string, LedgerLine>; ///< by id

class Ledger {
  public:
    /// The lines in FILE, the last of each id; read alone.
    static Result<LedgerLines> read(const std::filesystem::path& file);

    /// Opens or makes it, whoever holds the folder's lock; one of more than twice as many lines as assets, and 64, is written anew.
    static Result<Ledger> open(const std::filesystem::path& file);

    /// What was there when it was opened.
    const LedgerLines& lines() const { return lines_; }

    /// On the disk when it returns. For any thread. Errors: write_failed.
    Result<void> record(const LedgerLine& line);

  private:
    Ledger(Journal journal, LedgerLines lines) : journal_(std::move(journal)), lines_(std::move(lines)), mutex_(std::make_unique<std::mutex>()) {}
    Journal journal_;
    LedgerLines lines_;
    std::unique_ptr<std::mutex> mutex_;
};

} // namespace reliefbake

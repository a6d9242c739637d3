#pragma once
// Finished outputs by what they were made from, shared by any number of runs and machines.

#include "bake/error.h"
#include "cli/batch/batch_plan.h"
#include "cli/batch/ledger.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// DIR/xx/HASH.bin holds bytes of that hash, DIR/xx/KEY.json names those of one bake. Both are written to a temporary and renamed, in this
/// order, and never changed: readers on any machine find all or nothing, over NFS too. What is read is checked against its hash;
/// what does not fit is as good as missing.
class BakeCache {
  public:
    explicit BakeCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Puts the outputs of an equal bake in place, all together, and completes `line` (outputs, statistics, warnings, seconds).
    /// False: there is none, or none that is whole. Errors: cannot_create, write_failed (the outputs).
    Result<bool> fetch(const BatchJob& job, const std::filesystem::path& out, LedgerLine& line) const;

    /// Keeps the outputs of a bake. Errors: cannot_create, write_failed (the cache); no_input (an output).
    Result<void> store(const BatchJob& job, const std::filesystem::path& out, const LedgerLine& line) const;

  private:
    std::filesystem::path file_for(const std::string& hash, const char* extension) const;
    std::filesystem::path folder_;
};

} // namespace reliefbake

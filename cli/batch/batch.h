#pragma once
// reliefbake batch DIR|GLOB|@LIST... --out DIR; reliefbake run, a shard of the same.

#include "cli/batch/batch_plan.h"
#include "cli/batch/batch_reporter.h"
#include "cli/batch/batch_runner.h"
#include "cli/batch/batch_sources.h"
#include "cli/batch/freshness.h"
#include "cli/batch/shard.h"
#include "cli/command.h"

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbake {

class BatchCommand : public Command {
  public:
    BatchCommand() = default;
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  protected:
    explicit BatchCommand(bool sharded) : sharded_(sharded) {}

  private:
    struct Work;
    Result<void> resolve();
    Result<BatchPlan> plan() const;
    Result<void> tell_plan(const BatchPlan& plan, const LedgerLines& known) const;
    /// Of the folder and, where this is a shard, its own.
    Result<LedgerLines> known_lines() const;
    Result<void> bake(BatchPlan& plan) const;
    Result<void> bake_left(BatchPlan& plan, BatchSummary summary, Ledger& ledger, BatchReporter& reporter) const;
    Result<Work> find_work(const BatchPlan& plan, const LedgerLines& known, Ledger& ledger) const;
    BatchSummary beginning(const BatchPlan& plan) const;
    Result<void> check_page(const BatchPlan& plan) const;
    Result<void> write_page(const BatchPlan& plan, const BatchSummary& summary) const;
    /// What this run keeps for the next one.
    std::filesystem::path state() const;

    const bool sharded_ = false;
    std::string shard_text_;
    int shards_ = 0;
    Shard shard_;
    BatchSources given_;
    std::string cache_, page_;
    RunLimits limits_{0, 0, 0, false};
    bool keep_going_ = false, dry_run_ = false, retry_failed_ = false, json_ = false, quiet_ = false;
    ReportTo report_;
};

/// One of N runs that share a folder, each with its own part of the assets, ledger and summary; `merge` puts them together.
class RunCommand : public BatchCommand {
  public:
    RunCommand() : BatchCommand(true) {}
};

} // namespace reliefbake

#pragma once
// reliefbake batch DIR|GLOB|@LIST... --out DIR

#include "cli/batch/batch_plan.h"
#include "cli/batch/batch_reporter.h"
#include "cli/batch/batch_runner.h"
#include "cli/batch/freshness.h"
#include "cli/command.h"

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbake {

class BatchCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    struct Work;
    Result<void> resolve();
    Result<BatchPlan> plan() const;
    Result<void> tell_plan(const BatchPlan& plan) const;
    Result<void> bake(BatchPlan& plan) const;
    Result<void> bake_left(BatchPlan& plan, BatchSummary summary, Ledger& ledger, BatchReporter& reporter) const;
    Result<Work> find_work(const BatchPlan& plan, Ledger& ledger) const;
    BatchSummary beginning(const BatchPlan& plan) const;

    std::vector<std::string> sources_;
    std::string out_, recipe_, name_ = "{stem}_{kind}", cache_;
    RunLimits limits_{0, 0, 0, false};
    bool keep_going_ = false, dry_run_ = false, retry_failed_ = false, json_ = false, quiet_ = false;
    ReportTo report_;
};

} // namespace reliefbake

#pragma once
// --report: what a batch left, on one page that holds everything it shows.

#include "cli/batch/asset_check.h"
#include "cli/batch/batch_plan.h"
#include "cli/batch/ledger.h"
#include "cli/batch/summary.h"

#include <string>
#include <vector>

namespace reliefbake {

struct ReportedAsset {
    const LedgerLine* line;
    AssetCheck check;
};

/// The page: the summary, failures with their reasons, and every asset, worst first (then by name).
std::string batch_html(const BatchSummary& summary, std::vector<ReportedAsset> assets);

/// Judges what each job of the plan left (of those with a true line), and draws the page.
std::string report_batch(const BatchPlan& plan, const LedgerLines& lines, const BatchSummary& summary, int threads);

} // namespace reliefbake

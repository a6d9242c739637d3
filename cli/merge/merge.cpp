#include "cli/merge/merge.h"

#include "cli/batch/batch_state.h"
#include "cli/batch/exit_codes.h"
#include "cli/merge/merge_bands.h"
#include "cli/merge/merge_shards.h"
#include "cli/options/thread_option.h"
#include "cli/report/format_text.h"

#include <cstdio>

namespace reliefbake {

void MergeCommand::add_to(CLI::App& app) {
    CLI::Option* bands = app.add_option("BAND", inputs_, "Bands of one map, as `cone --rows` writes them, in any order");
    app.option_defaults()->group("Result");
    CLI::Option* output = app.add_option("-o,--output", output_, "Map to write of the bands: .exr .tif")->type_name("OUT")->needs(bands);
    bands->needs(output);
    CLI::Option* out = app.add_option("--out", out_, "Instead: the folder that all shards of a batch baked into (`run`)")->type_name("DIR")->excludes(bands)->excludes(output);
    app.option_defaults()->group("Run");
    add_thread_option(app, threads_);
    out->excludes(app.get_option("--threads"));
    CLI::Option* json = app.add_flag("--json", json_, "Print one result object (cli/schema/merge.schema.json, batch_summary.schema.json)");
    app.add_flag("--quiet", quiet_, "Print nothing unless something is wrong")->excludes(json);
}

Result<void> MergeCommand::merge_batch() const {
    const Result<BatchSummary> summary = merge_shards(out_);
    if (!summary) return tl::unexpected(summary.error());
    if (!quiet_) std::fputs((json_ ? to_json(*summary).dump(2) + "\n" : summary_text(*summary)).c_str(), stdout);
    if (summary->failures.empty()) return {};
    return fail(partial_failure, format("%zu of %zu assets failed; ", summary->failures.size(), summary->assets) + summary_file(state_folder(out_)).string() + " names them");
}

Result<void> MergeCommand::run() {
    if (!out_.empty()) return merge_batch();
    if (inputs_.empty()) return fail(ErrorCode::usage, "what? Name bands and -o, or the folder of a batch with --out");
    return resolve_threads(threads_).and_then([&](int threads) {
        return merge_bands(inputs_, output_, threads, json_ ? MergeOutput::json : quiet_ ? MergeOutput::none : MergeOutput::text);
    });
}

} // namespace reliefbake

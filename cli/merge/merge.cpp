#include "cli/merge/merge.h"

#include "cli/merge/merge_bands.h"
#include "cli/options/thread_option.h"

namespace reliefbake {

void MergeCommand::add_to(CLI::App& app) {
    app.add_option("BAND", inputs_, "Bands of one map, as `cone --rows` writes them, in any order")->required();
    app.option_defaults()->group("Result");
    app.add_option("-o,--output", output_, "Map to write: .exr .tif")->required()->type_name("OUT");
    app.option_defaults()->group("Run");
    add_thread_option(app, threads_);
    CLI::Option* json = app.add_flag("--json", json_, "Print one result object (cli/schema/merge.schema.json)");
    app.add_flag("--quiet", quiet_, "Print nothing unless something is wrong")->excludes(json);
}

Result<void> MergeCommand::run() {
    return resolve_threads(threads_).and_then([&](int threads) {
        return merge_bands(inputs_, output_, threads, json_ ? MergeOutput::json : quiet_ ? MergeOutput::none : MergeOutput::text);
    });
}

} // namespace reliefbake

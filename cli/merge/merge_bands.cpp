#include "cli/merge/merge_bands.h"

#include "cli/output_checks.h"
#include "cli/report/format_text.h"
#include "cli/stage_clock.h"
#include "formats/join_bands.h"

#include <cstdio>

namespace reliefbake {

namespace {

using nlohmann::json;

Result<std::vector<BandReader>> open_bands(const std::vector<std::string>& files, const std::string& output) {
    std::vector<BandReader> bands;
    for (const std::string& file : files) {
        if (Result<void> other = validate_not_input(file, output); !other) return tl::unexpected(other.error());
        Result<BandReader> band = BandReader::open(file);
        if (!band) return tl::unexpected(band.error());
        bands.push_back(std::move(*band));
    }
    if (Result<void> ordered = order_bands(bands); !ordered) return tl::unexpected(ordered.error());
    return bands;
}

void print(const std::vector<BandReader>& bands, const json& map, const std::string& output, const StageClock::Seconds& seconds, MergeOutput report) {
    const BandFacts& facts = bands.front().facts();
    if (report == MergeOutput::text)
        std::fputs(format("%s: %d x %d from %zu bands\n", output.c_str(), facts.width, facts.height, bands.size()).c_str(), stdout);
    if (report != MergeOutput::json) return;
    json result = {{"output", output}, {"width", facts.width}, {"height", facts.height}, {"map", map}, {"bands", json::array()}, {"seconds", json::object()}};
    for (const BandReader& band : bands) result["bands"].push_back({{"file", band.name()}, {"rows", {band.facts().first, band.facts().end}}});
    for (const auto& [stage, duration] : seconds) result["seconds"][stage] = duration;
    std::fputs((result.dump(2, ' ', false, json::error_handler_t::replace) + "\n").c_str(), stdout);
}

} // namespace

Result<void> merge_bands(const std::vector<std::string>& files, const std::string& output, int threads, MergeOutput report) {
    StageClock clock(report != MergeOutput::none);
    const Result<std::vector<BandReader>> bands = open_bands(files, output).and_then([&](std::vector<BandReader> opened) {
        return validate_output_folder(output).map([&] { return std::move(opened); });
    });
    if (!bands) return tl::unexpected(bands.error());
    const Result<void> whole = clock.time("check", [&]() -> Result<void> {
        for (const BandReader& band : *bands)
            if (Result<void> same = band.check_sum(); !same) return same;
        return {};
    });
    if (!whole) return whole;
    FileBatch batch;
    const Result<json> map = clock.time("write", [&] { return write_joined_map(output, *bands, batch, threads); });
    if (!map) return tl::unexpected(map.error());
    if (Result<void> published = batch.publish(); !published) return published;
    clock.stop();
    print(*bands, *map, output, clock.seconds(), report);
    return {};
}

} // namespace reliefbake

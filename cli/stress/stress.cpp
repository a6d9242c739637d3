#include "cli/stress/stress.h"

#include "cli/choices.h"
#include "cli/options/thread_option.h"
#include "cli/version.h"
#include "formats/atomic_file.h"

#include <cstdio>
#include <filesystem>
#include <iterator>

namespace reliefbake {
namespace {

constexpr int quick_widest = 4096, widest = 65536; ///< of the strips that encodings are compared on
/// Larger fields are baked repeated alone, at both ends of the bit depths.
constexpr std::int64_t many_texels = 1 << 20;

const char* word_of_extent(StressExtent extent) { return extent == StressExtent::quick ? "quick" : extent == StressExtent::full ? "full" : "standard"; }

std::string names_of(const std::vector<StressField>& fields) {
    std::string names;
    for (const StressField& field : fields) names += (names.empty() ? "" : ", ") + field.name;
    return names;
}

} // namespace

void StressCommand::add_to(CLI::App& app) {
    app.add_option("-o,--output", folder_, "Folder for stress.json (cli/schema/stress.schema.json), kept.svg and dead.svg")->type_name("DIR");
    app.add_flag("--json", json_, "Print stress.json instead of lines");
    CLI::Option* quick = app.add_flag("--quick", quick_, "Smaller fields, 8 bits and floats alone, fewer rays: less than a minute instead of several");
    app.add_flag("--full", full_, "16384 x 16384 texels, too: 8 GB of memory")->excludes(quick);
    app.add_option("--only", only_, "Only the case of this name, or those whose names begin with it")->type_name("CASE");
    add_thread_option(app, effort_.threads);
}

StressExtent StressCommand::extent() const { return quick_ ? StressExtent::quick : full_ ? StressExtent::full : StressExtent::standard; }

Result<std::vector<StressField>> StressCommand::wanted_fields() const {
    std::vector<StressField> all = stress_fields(extent()), wanted;
    std::copy_if(all.begin(), all.end(), std::back_inserter(wanted), [&](const StressField& field) { return !only_ || (!only_->empty() && field.name.starts_with(*only_)); });
    if (wanted.empty()) return fail(ErrorCode::usage, "--only: no case begins with '" + *only_ + "', expected one of " + names_of(all));
    return wanted;
}

Result<std::vector<StressResult>> StressCommand::run_field(const StressField& field) const {
    std::vector<StressResult> results;
    const auto keep = [&](Result<StressResult> result) -> Result<void> {
        if (!result) return tl::unexpected(result.error());
        results.push_back(std::move(*result));
        return {};
    };
    if (!field.march) {
        if (Result<void> kept = keep(run_largest_case(field, ConeEncoding::sqrt, BitDepth::unorm8, effort_)); !kept) return tl::unexpected(kept.error());
        return results;
    }
    const bool large = std::int64_t(field.width) * field.height > many_texels;
    for (const auto& [bits_word, bits] : bits_words) {
        if ((quick_ || large) && bits != BitDepth::unorm8 && bits != BitDepth::float32) continue;
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
            if (large && wrap == Wrap::clamp) continue;
            const Result<BakeSource> source = stress_source(field, bits, wrap);
            if (!source) return tl::unexpected(source.error());
            RepresentationBaker baker(*source, field.depth_scale, effort_.threads);
            for (const auto& [encoding_word, encoding] : encoding_words)
                if (Result<void> kept = keep(run_stress_case(field, baker, encoding, bits, effort_)); !kept) return tl::unexpected(kept.error());
        }
    }
    return results;
}

Result<void> StressCommand::write(const nlohmann::json& report, const std::vector<Usefulness>& measured) const {
    const auto write_text = [&](const char* name, const std::string& text) {
        return write_file_atomically(std::filesystem::path(folder_) / name, text);
    };
    return write_text("kept.svg", kept_svg(measured)).and_then([&] { return write_text("dead.svg", dead_svg(measured)); }).and_then([&] {
        return write_text("stress.json", report.dump(1) + "\n");
    });
}

Result<void> StressCommand::run() {
    const Result<int> threads = resolve_threads(effort_.threads);
    if (!threads) return tl::unexpected(threads.error());
    effort_.threads = *threads;
    if (quick_) effort_.rays = 1600, effort_.points = 400, effort_.exact_points = 8, effort_.crop = 3;
    const Result<std::vector<StressField>> fields = wanted_fields();
    if (!fields) return tl::unexpected(fields.error());
    if (!folder_.empty()) {
        std::error_code error;
        std::filesystem::create_directories(folder_, error);
        if (error) return fail(ErrorCode::cannot_create, folder_ + ": cannot create the folder: " + error.message());
    }

    Result<ReliefRenderer> renderer = ReliefRenderer::create(RendererBackend::osmesa);
    if (!renderer) return tl::unexpected(renderer.error());
    effort_.renderer = &*renderer;

    // Cases, told as they end.
    nlohmann::json report{{"version", version()}, {"extent", word_of_extent(extent())}, {"cases", nlohmann::json::array()}};
    std::size_t violated = 0;
    if (!json_) std::fputs(stress_heading().c_str(), stdout);
    for (const StressField& field : *fields) {
        const Result<std::vector<StressResult>> results = run_field(field);
        if (!results) return tl::unexpected(results.error());
        for (const StressResult& result : *results) report["cases"].push_back(to_json(result)), violated += !result.holds();
        if (!json_) std::fputs(stress_line(field.name, *results).c_str(), stdout);
        std::fflush(stdout);
    }
    report["violated"] = violated;

    const std::vector<Usefulness> measured = measure_usefulness(quick_ ? quick_widest : widest, effort_.threads);
    report.update(usefulness_json(measured));
    std::fputs((json_ ? report.dump(1) + "\n" : usefulness_text(measured)).c_str(), stdout);
    if (!folder_.empty())
        if (Result<void> written = write(report, measured); !written) return written;
    if (violated == 0) return {};
    return fail(ErrorCode::verification, std::to_string(violated) + " of " + std::to_string(report["cases"].size()) + " bakes do not hold: see those with \"holds\": false in --json");
}

} // namespace reliefbake

#include "cli/bench/bench_cone.h"

#include "bake/height_field.h"
#include "cli/bench/fields.h"
#include "cli/bench/peers.h"
#include "cli/bench/simd_words.h"
#include "cli/bench/time_cones.h"
#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "cli/options/range_option.h"
#include "cli/options/thread_option.h"
#include "cli/options/wrap_option.h"
#include "cli/version.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace reliefbake {

namespace {

constexpr double seconds_per_peer = 0.5;

std::string machine_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown";
}

void print_times(const nlohmann::json& r) {
    std::printf("%-28s %5dx%-5d %8.1f ns/texel  near %6.1f  pyramid %5.1f  far %7.1f\n",
                r["name"].get<std::string>().c_str(), r["width"].get<int>(), r["height"].get<int>(),
                r["search_ns_per_texel"].get<double>(), r["near_ns_per_texel"].get<double>(),
                r["pyramid_ns_per_texel"].get<double>(), r["far_ns_per_texel"].get<double>());
    for (const nlohmann::json& peer : r.value("peers", nlohmann::json::array()))
        std::printf("    %-24s %12.0f ns/texel  %9.1f times ours\n", peer["name"].get<std::string>().c_str(),
                    peer["ns_per_texel"].get<double>(), peer["times_ours"].get<double>());
    for (const nlohmann::json& row : r.value("adaptive", nlohmann::json::array()))
        std::printf("    %-24s %12.0f ns/texel  %9.1f times the exact method; cones too wide: %.2f %%\n", row["name"].get<std::string>().c_str(),
                    row["ns_per_texel"].get<double>(), row["times_exact"].get<double>(), 100 * row["too_wide"].get<double>());
    if (!r.contains("compare")) return;
    std::printf("    %-46s %10s %10s %7s %6s %9s %10s\n", "method", "violations", "missed", "steps", "max", "tightness", "ns/texel");
    for (const nlohmann::json& row : r["compare"])
        std::printf("    %-46s %10ld %10.2e %7.2f %6d %9.3f %10.1f\n", row["method"].get<std::string>().c_str(),
                    row["violations"].get<long>(), row["missed"].get<double>(), row["steps_mean"].get<double>(),
                    row["steps_max"].get<int>(), row["tightness"].get<double>(), row["bake_ns_per_texel"].get<double>());
}

} // namespace

void BenchConeCommand::add_to(CLI::App& app) {
    CLI::Option* file = app.add_option("FILE", file_, "Height map to time (default: every synthetic field)");
    app.option_defaults()->group("Subject");
    app.add_option("--channel", read_.channel, "Its channel (default: the only one, else luminance)")->needs(file);
    add_choice(app, "--input", height_.input, input_words, "What white means in it (default height)")->needs(file);
    add_range_option(app, height_)->needs(file);
    add_wrap_option(app, height_.wrap_x, height_.wrap_y);
    app.add_option("--field", field_, "One synthetic field: ramp, pyramid, hill, saw-tooth, stairs, checkerboard, "
                                      "spike, noise, constant, fbm")
        ->check(CLI::IsMember(field_names()))
        ->excludes(file);
    app.add_option("--size", size_, "Side of synthetic fields (default 1024)")->check(CLI::Range(1, 16384))->excludes(file);
    app.option_defaults()->group("Bake");
    add_choice(app, "--surface", cone_.surface, surface_words, "Surface that no cone may touch (default bilinear)");
    add_choice(app, "--metric", cone_.metric, metric_words, "How distance is measured (default l2)");
    add_number(app, "--tolerance", cone_.tolerance, fraction_number, "As for `cone` (default 0.001)");
    add_thread_option(app, cone_.threads);
    add_family_options(app, family_, true);
    app.add_option("--sectors", sectors_, "Sectors of an anisotropic map (default 1: none)")->check(CLI::IsMember({1, 4, 8}));
    CLI::Option* levels = app.add_option("--levels", levels_, "Levels of a cone stack (default 1: none)")->check(CLI::Range(1, 16));
    app.add_option("--method", method_, "1: whole cones, 2: pieces of one (default 1)")->check(CLI::IsMember({1, 2}))->needs(levels);
    app.option_defaults()->group("Bake");
    add_choice(app, "--simd", simd_, simd_words(), "Instruction set (default: the widest this machine has)");
    CLI::Option* adaptive = app.add_option("--adaptive", adaptive_levels_,
                                           "Also time 002's Algorithm 1 with this many levels, and its original ring search (level 0)")
                                ->check(CLI::Range(1, 16));
    add_number(app, "--similarity", similarity_, fraction_number, "Of --adaptive (default 0.05)")->needs(adaptive);
    app.option_defaults()->group("Measurement");
    app.add_option("--repeat", repeat_, "Bakes; the fastest counts (default 5)")->check(CLI::Range(1, 1000));
    app.add_flag("--peers", peers_, "Also time brute force, the expanding ring and the quick cone map");
    app.add_flag("--compare", compare_, "Also verify our maps and others': violations, missed rays, steps");
    app.add_flag("--json", json_, "Print one object");
}

Result<BenchConeCommand::Subject> BenchConeCommand::file_subject() const {
    const Result<SourceImage> source = read_image(file_, read_);
    if (!source) return tl::unexpected(source.error());
    const Result<CheckedHeight> height = make_height_field(source->plane, source->is_integer, height_, file_);
    if (!height) return tl::unexpected(height.error());
    return Subject{file_.substr(file_.find_last_of('/') + 1), quantise_depth(height->field, BitDepth::unorm16)};
}

Result<std::vector<BenchConeCommand::Subject>> BenchConeCommand::subjects() const {
    std::vector<Subject> out;
    if (!file_.empty()) {
        Result<Subject> subject = file_subject();
        if (!subject) return tl::unexpected(subject.error());
        out.push_back(std::move(*subject));
        return out;
    }
    for (const std::string& name : field_names())
        if (field_.empty() || field_ == name) out.push_back({name, make_field(name, size_)});
    return out;
}

Result<void> BenchConeCommand::run() {
    const Result<int> threads = resolve_threads(cone_.threads);
    if (!threads) return tl::unexpected(threads.error());
    cone_.threads = *threads;
    if (const Result<void> resolved = resolve_family(family_, cone_); !resolved) return resolved;
    const bool stacked = levels_ > 1 || method_ == 2;
    const bool plain = cone_.family == ConeFamily::conservative && cone_.lookup == ConeLookup::filtered && sectors_ == 1 && !stacked;
    const bool relaxed = cone_.family == ConeFamily::relaxed && sectors_ == 1;
    if (compare_ && !plain) return fail(ErrorCode::usage, "--compare: is for conservative cones of all directions");
    if (peers_ && !plain && !relaxed) return fail(ErrorCode::usage, "--peers: are for conservative and relaxed cones of all directions");
    if (sectors_ > 1 && (cone_.family == ConeFamily::hybrid || stacked))
        return fail(ErrorCode::usage, "--sectors: sectors are conservative or relaxed, and not stacked");
    if (adaptive_levels_ && (sectors_ == 1 || cone_.family != ConeFamily::conservative || cone_.metric != Metric::l2))
        return fail(ErrorCode::usage, "--adaptive: needs --sectors 4 or 8, conservative l2 cones");
    if (stacked && cone_.family != ConeFamily::conservative) return fail(ErrorCode::usage, "--levels: stacked cones are conservative");
    if (sectors_ == 8 && cone_.metric == Metric::l1) return fail(ErrorCode::usage, "--sectors 8: needs --metric l2");
    use_simd(simd_);
    const Result<std::vector<Subject>> subjects = this->subjects();
    if (!subjects) return tl::unexpected(subjects.error());

    nlohmann::json results = nlohmann::json::array();
    for (const auto& [name, depth] : *subjects) {
        nlohmann::json result = time_bake(depth, cone_, {sectors_, levels_, method_ == 2}, repeat_);
        result.update({{"name", name}, {"width", depth.grid.width}, {"height", depth.grid.height}});
        if (peers_)
            for (const Peer& peer : relaxed ? std::vector<Peer>{sampled_relaxed_peer()}
                                            : std::vector<Peer>{brute_force_peer(), expanding_ring_peer(), quick_cone_map_peer()}) {
                nlohmann::json timed = time_peer(peer, depth, cone_.ratio_max, seconds_per_peer);
                timed["times_ours"] = timed["ns_per_texel"].get<double>() / result["search_ns_per_texel"].get<double>();
                result["peers"].push_back(std::move(timed));
            }
        if (adaptive_levels_) {
            result["adaptive"] = time_adaptive(depth, {sectors_, *adaptive_levels_, similarity_}, cone_);
            for (nlohmann::json& row : result["adaptive"])
                row["times_exact"] = row["ns_per_texel"].get<double>() / result["search_ns_per_texel"].get<double>();
        }
        if (compare_) {
            const Result<nlohmann::json> compared = compare_maps(depth, cone_);
            if (!compared) return tl::unexpected(compared.error());
            result["compare"] = *compared;
        }
        if (!json_) print_times(result);
        results.push_back(std::move(result));
    }
    if (!json_) return {};
    // One subject's numbers stand at the top level too, where scripts look for search_ns_per_texel.
    nlohmann::json out = results.size() == 1 ? results[0] : nlohmann::json::object();
    out.update({{"machine", machine_name()}, {"threads", cone_.threads}, {"simd", to_string(simd_)}, {"results", results}});
    std::printf("%s\n", out.dump(2).c_str());
    return {};
}

} // namespace reliefbake

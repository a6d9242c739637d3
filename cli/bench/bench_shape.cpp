#include "cli/bench/bench_shape.h"

#include "cli/bench/pictures.h"
#include "cli/bench/plain_distances.h"
#include "cli/bench/python_peers.h"
#include "cli/bench/simd_words.h"
#include "cli/choices.h"
#include "cli/options/thread_option.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>

namespace reliefbake {

namespace {

const Words<DistanceTo> to_words = {{"centres", DistanceTo::centres}, {"squares", DistanceTo::squares}};

/// Bytes that any transform must read and write, a pixel.
constexpr double bytes_a_pixel = sizeof(std::uint8_t) + sizeof(float);

/// Seconds of the fastest of `repeat` runs.
double fastest(int repeat, const std::function<void()>& work) {
    double best = HUGE_VAL;
    for (int k = 0; k < repeat; ++k) {
        const auto start = std::chrono::steady_clock::now();
        work();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

/// The four of the peers' geometric mean; dots are timed beside them.
bool is_in_mean(const std::string& name) { return name != "dots"; }

void print(const nlohmann::json& r) {
    std::printf("%-10s %6d  ours %6.2f ns/pixel, %5.2f GB/s; fresh output %6.2f; copy %5.2f GB/s\n", r["picture"].get<std::string>().c_str(),
                r["size"].get<int>(), r["ns_per_pixel"].get<double>(), r["gb_per_second"].get<double>(), r["fresh_ns_per_pixel"].get<double>(),
                r["copy_gb_per_second"].get<double>());
    for (const nlohmann::json& peer : r["peers"])
        std::printf("    %-32s %8.2f ns/pixel, %6.2f times ours; wrong %.4f %%, by at most %.3g\n", peer["name"].get<std::string>().c_str(),
                    peer["ns_per_pixel"].get<double>(), peer["times_ours"].get<double>(), 100 * peer["wrong"].get<double>(),
                    peer["error_max"].get<double>());
}

/// Time of the textbook's transform, and how much of ours differs from it.
nlohmann::json time_plain(const Image<std::uint8_t>& picture, const Image<float>& ours, int threads, int repeat) {
    std::atomic<std::uint64_t> wrong = 0;
    const auto compare = [&](int y, const float* row) {
        if (std::memcmp(row, ours.row(y), std::size_t(ours.width()) * sizeof(float)) == 0) return;
        for (int x = 0; x < ours.width(); ++x) wrong += row[x] != ours(x, y);
    };
    const double seconds = fastest(repeat, [&] { plain_distances(picture, threads, compare); });
    const double pixels = double(picture.size());
    return {{"name", "plain (Meijster and others)"}, {"version", ""}, {"ns_per_pixel", seconds * 1e9 / pixels},
            {"wrong", double(wrong) / repeat / pixels}, {"error_max", 0}};
}

} // namespace

void BenchShapeCommand::add_to(CLI::App& app) {
    app.add_option("--picture", picture_, "One picture: blobs, lines, pixel, diagonal, dots (default: all)")->check(CLI::IsMember(picture_names()));
    app.add_option("--size", size_, "Its side (default 4096)")->check(CLI::Range(1, 65536));
    add_choice(app, "--to", to_, to_words, "What is measured to: texel centres, or squares (default centres)");
    add_thread_option(app, threads_);
    add_choice(app, "--simd", simd_, simd_words(), "Instruction set (default: the widest this machine has)");
    app.add_option("--repeat", repeat_, "Runs; the fastest counts (default 5)")->check(CLI::Range(1, 1000));
    app.add_flag("--plain", plain_, "Also time the textbook's transform, a second exact one, and compare: exit code 4 where ours differs");
    app.add_flag("--peers", peers_, "Also time OpenCV and SciPy where python3 has them (python3-opencv, python3-scipy)");
    app.add_flag("--json", json_, "Print one object");
}

Result<nlohmann::json> BenchShapeCommand::time_picture(const std::string& name) const {
    const Image<std::uint8_t> picture = make_picture(name, size_);
    const DistanceOptions options{to_, 0, false, false, threads_};
    const double pixels = double(picture.size());
    Image<float> out(size_, size_);
    const double seconds = fastest(repeat_, [&] { distance_transform(picture, options, out); });
    const double fresh = fastest(std::min(repeat_, 3), [&] { (void)distance_transform(picture, options); });
    nlohmann::json peers = nlohmann::json::array();
    if (plain_) peers.push_back(time_plain(picture, out, threads_, std::min(repeat_, 3)));
    if (peers_) {
        const Result<nlohmann::json> python = time_python_peers(picture, out, {threads_, std::min(repeat_, 3)});
        if (!python) return tl::unexpected(python.error());
        peers.insert(peers.end(), python->begin(), python->end());
    }
    for (nlohmann::json& peer : peers) peer["times_ours"] = peer["ns_per_pixel"].get<double>() * pixels / 1e9 / seconds;
    // A copy that reads and writes as many bytes in all: half of them each.
    const std::size_t half = std::size_t(pixels * bytes_a_pixel / 2);
    const std::vector<char> from(half, 1);
    const double copy = fastest(repeat_, [&] { std::memcpy(out.data(), from.data(), half); });
    return nlohmann::json{{"picture", name},
                          {"size", size_},
                          {"ns_per_pixel", seconds * 1e9 / pixels},
                          {"fresh_ns_per_pixel", fresh * 1e9 / pixels},
                          {"gb_per_second", pixels * bytes_a_pixel / seconds / 1e9},
                          {"copy_gb_per_second", pixels * bytes_a_pixel / copy / 1e9},
                          {"peers", peers}};
}

Result<void> BenchShapeCommand::run() {
    const Result<int> threads = resolve_threads(threads_);
    if (!threads) return tl::unexpected(threads.error());
    threads_ = *threads;
    if ((plain_ || peers_) && to_ == DistanceTo::squares)
        return fail(ErrorCode::usage, "--to squares: the others measure to centres alone; leave out --plain and --peers");
    use_simd(simd_);
    nlohmann::json results = nlohmann::json::array();
    std::map<std::string, std::pair<double, int>> logs; // of the times of ours and of each peer
    bool differs = false;
    const auto count = [&](const std::string& name, double time) { logs[name].first += std::log(time), ++logs[name].second; };
    for (const std::string& name : picture_names()) {
        if (!picture_.empty() && picture_ != name) continue;
        Result<nlohmann::json> result = time_picture(name);
        if (!result) return tl::unexpected(result.error());
        if (is_in_mean(name)) {
            count("ours", (*result)["ns_per_pixel"]);
            for (const nlohmann::json& peer : (*result)["peers"]) count(peer["name"], peer["ns_per_pixel"]);
        }
        if (plain_) differs = differs || (*result)["peers"][0]["wrong"] != 0.0;
        if (!json_) print(*result);
        results.push_back(std::move(*result));
    }
    nlohmann::json means = nlohmann::json::object();
    for (const auto& [name, sum] : logs) means[name] = std::exp(sum.first / sum.second);
    if (json_) {
        const nlohmann::json out{{"size", size_}, {"threads", threads_}, {"simd", to_string(simd_)}, {"to", word_of(to_words, to_)},
                                 {"geometric_mean_ns_per_pixel", means}, {"results", results}};
        std::printf("%s\n", out.dump(2).c_str());
    } else {
        for (const auto& [name, mean] : means.items())
            std::printf("geometric mean%s %-32s %6.2f ns/pixel, %d threads\n", picture_.empty() ? " of the first four" : "", name.c_str(), mean.get<double>(), threads_);
    }
    if (differs) return fail(ErrorCode::verification, "distances differ from those of the textbook's transform");
    return {};
}

} // namespace reliefbake

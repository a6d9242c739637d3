#include "cli/bench/bench_dynamic.h"

#include "bake/acm_adaptive.h"
#include "bake/cone.h"
#include "cli/options/thread_option.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

namespace reliefbake {

namespace {

/// A sum of sinusoids that travel in four directions and tile, heights 0..1.
DepthMap water(int size, double time) {
    constexpr double turn = 6.283185307179586;
    constexpr int waves[][2] = {{1, 2}, {-3, 1}, {2, -5}, {4, 3}};
    DepthMap depth{{size, size, Wrap::repeat, Wrap::repeat, 1}, BitDepth::unorm8, Image<float>(size, size)};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            double height = 0;
            for (const auto& [u, v] : waves) height += std::sin(turn * (double(u * x + v * y) / size + time));
            depth.level(x, y) = float(std::lround((0.5 - height / 8) * 255));
        }
    return depth;
}

/// Maps per second.
double rate(int frames, int size, const std::function<void(const DepthMap&)>& bake) {
    double seconds = 0;
    for (int k = 0; k < frames; ++k) {
        const DepthMap depth = water(size, double(k) / frames);
        const auto start = std::chrono::steady_clock::now();
        bake(depth);
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    return frames / seconds;
}

} // namespace

void BenchDynamicCommand::add_to(CLI::App& app) {
    app.add_option("--size", size_, "Side of the map (default 128)")->check(CLI::Range(8, 4096));
    app.add_option("--frames", frames_, "Maps to bake (default 20)")->check(CLI::Range(1, 10000));
    app.add_option("--sectors", sectors_, "Sectors (default 4)")->check(CLI::IsMember({4, 8}));
    add_thread_option(app, threads_);
    app.add_flag("--json", json_, "Print one object");
}

Result<void> BenchDynamicCommand::run() {
    const Result<int> threads = resolve_threads(threads_);
    if (!threads) return tl::unexpected(threads.error());
    ConeOptions options;
    options.threads = *threads;
    AdaptiveOptions adaptive;
    adaptive.sectors = sectors_;
    AdaptiveOptions original = adaptive;
    original.levels = 0;
    nlohmann::json result{{"size", size_}, {"sectors", sectors_}, {"threads", *threads}, {"frames", frames_}};
    result["exact_maps_per_second"] = rate(frames_, size_, [&](const DepthMap& d) { bake_sector_cones(d, sectors_, options); });
    result["adaptive_maps_per_second"] = rate(frames_, size_, [&](const DepthMap& d) { bake_sector_cones_adaptive(d, adaptive, options); });
    result["ring_search_maps_per_second"] = rate(frames_, size_, [&](const DepthMap& d) { bake_sector_cones_adaptive(d, original, options); });
    if (json_) {
        std::printf("%s\n", result.dump(2).c_str());
        return {};
    }
    std::printf("%dx%d, %d sectors, %d threads, maps a second: exact %.1f, adaptive (002, Algorithm 1) %.1f, its original ring search %.1f\n",
                size_, size_, sectors_, *threads, result["exact_maps_per_second"].get<double>(),
                result["adaptive_maps_per_second"].get<double>(), result["ring_search_maps_per_second"].get<double>());
    return {};
}

} // namespace reliefbake

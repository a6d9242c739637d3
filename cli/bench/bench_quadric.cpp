#include "cli/bench/bench_quadric.h"

#include "cli/bench/quadric_accuracy.h"
#include "cli/options/thread_option.h"
#include "cli/quadric/quadric_options.h"
#include "mesh/jet_fit.h"
#include "mesh/paper_fit.h"
#include "mesh/surface_fit.h"
#include "mesh/vertex_frames.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <numeric>

namespace reliefbake {

using nlohmann::json;

namespace {

/// Seconds of the fastest of `repeat` runs.
template <class Work>
double fastest(int repeat, Work work) {
    double best = std::numeric_limits<double>::infinity();
    for (int k = 0; k < repeat; ++k) {
        const auto start = std::chrono::steady_clock::now();
        work();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

std::vector<QuadricFit> fits() {
    std::vector<QuadricFit> all{QuadricFit::paper, QuadricFit::ring};
    if (has_jet_fit()) all.push_back(QuadricFit::jet);
    return all;
}

/// Nanoseconds a vertex: welding, adjacency and the default fit together, then the parts and the other fits.
json time_torus(const Mesh& mesh, int repeat, int threads) {
    const double unit = 1e9 / double(mesh.positions.size());
    Mesh framed = mesh;
    std::vector<std::uint32_t> source(mesh.positions.size());
    std::iota(source.begin(), source.end(), 0u);
    const WeldedSurface surface = weld_surface(mesh, threads);
    const SurfaceFit fit = fit_surface(surface, threads);
    QuadricCounts counts;
    complete_normals(framed, surface.weld, fit);
    complete_tangents(framed, source, FrameKind::principal, surface.weld, fit, counts);
    json times = {
        {"weld", unit * fastest(repeat, [&] { weld_positions(mesh.positions, threads); })},
        {"adjacency", unit * fastest(repeat, [&] { list_corners(mesh, surface.weld, threads); })},
        {"ring", unit * fastest(repeat, [&] { fit_surface(surface, threads); })},
        {"paper", unit * fastest(repeat, [&] { fit_as_printed(framed, source, surface, threads); })},
        {"total", unit * fastest(repeat, [&] { fit_surface(weld_surface(mesh, threads), threads); })}};
    if (has_jet_fit()) times["jet"] = unit * fastest(1, [&] { fit_jets(surface, fit, threads); });
    return times;
}

/// One row for each surface, kind of mesh, turn of the frames and fit, with three resolutions.
Result<json> measure_accuracy(int threads) {
    json rows = json::array();
    for (const std::string& name : surface_names())
        for (const bool irregular : {false, true})
            for (const double degrees : {0.0, 22.5, 45.0})
                for (const QuadricFit fit : fits()) {
                    json row = {{"surface", name}, {"irregular", irregular}, {"degrees", degrees}, {"fit", word_of_fit(fit)}};
                    for (const int detail : {1, 2, 3}) {
                        SurfaceMesh surface = make_surface(name, detail, irregular);
                        set_turned_tangents(surface, degrees);
                        QuadricOptions options;
                        options.fit = fit, options.threads = threads;
                        const Result<QuadricBake> bake = bake_quadrics(surface.mesh, options, name);
                        if (!bake) return tl::unexpected(bake.error());
                        const CurvatureError error = curvature_error(surface, *bake);
                        row["steps"].push_back({{"vertices", surface.mesh.positions.size()}, {"rms", error.rms}, {"max", error.max}});
                    }
                    rows.push_back(std::move(row));
                }
    return rows;
}

void print_accuracy(const json& rows) {
    std::printf("error of the curvature, %% of the largest: root mean square (maximum), at three resolutions\n");
    for (const json& row : rows) {
        std::printf("%-9s %-9s frames turned %4.1f degrees  %-5s", row["surface"].get<std::string>().c_str(), row["irregular"].get<bool>() ? "irregular" : "regular",
                    row["degrees"].get<double>(), row["fit"].get<std::string>().c_str());
        for (const json& step : row["steps"]) std::printf("  %8.4f (%8.3f)", 100 * step["rms"].get<double>(), 100 * step["max"].get<double>());
        std::printf("\n");
    }
}

} // namespace

void BenchQuadricCommand::add_to(CLI::App& app) {
    app.add_option("--rings", rings_, "Vertices around the torus that is timed (default 1024)")->check(CLI::Range(3, 8192));
    app.add_option("--sides", sides_, "Vertices around its tube (default 1024)")->check(CLI::Range(3, 8192));
    app.add_option("--repeat", repeat_, "Runs; the fastest counts (default 5)")->check(CLI::Range(1, 1000));
    app.add_flag("--accuracy", accuracy_, "Errors on surfaces of known curvature instead of times");
    add_thread_option(app, threads_);
    app.add_flag("--json", json_, "Print one object");
}

Result<void> BenchQuadricCommand::run() {
    const Result<int> threads = resolve_threads(threads_);
    if (!threads) return tl::unexpected(threads.error());
    if (accuracy_) {
        const Result<json> rows = measure_accuracy(*threads);
        if (!rows) return tl::unexpected(rows.error());
        if (json_) std::printf("%s\n", json{{"accuracy", *rows}}.dump(2).c_str());
        else print_accuracy(*rows);
        return {};
    }
    const Mesh mesh = make_torus(rings_, sides_);
    const json times = time_torus(mesh, repeat_, *threads);
    if (json_) {
        std::printf("%s\n", json{{"vertices", mesh.positions.size()}, {"threads", *threads}, {"ns_per_vertex", times}}.dump(2).c_str());
        return {};
    }
    std::printf("torus of %zu vertices, %d threads, ns/vertex\n", mesh.positions.size(), *threads);
    std::printf("  welding, adjacency and default fit %7.1f\n", times["total"].get<double>());
    for (const auto& [name, time] : times.items())
        if (name != "total") std::printf("  %-34s %7.1f\n", name.c_str(), time.get<double>());
    return {};
}

} // namespace reliefbake

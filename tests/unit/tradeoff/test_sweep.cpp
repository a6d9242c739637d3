#include "cli/tradeoff/pareto.h"
#include "cli/tradeoff/sweep.h"
#include "tests/unit/formats/temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <random>
#include <set>

using namespace reliefbake;
using reliefbake::test::TemporaryFolder;

TEST_CASE("a Pareto front is what no other point beats") {
    std::mt19937 random(11);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<CostAndError> points(random() % 12);
        for (CostAndError& point : points) point = {double(random() % 6), double(random() % 6)}; // many ties
        const std::vector<std::size_t> front = pareto_front(points);
        std::set<std::pair<double, double>> expected, found;
        for (const CostAndError& a : points) {
            const bool beaten = std::any_of(points.begin(), points.end(), [&](const CostAndError& b) {
                return b.cost <= a.cost && b.error <= a.error && (b.cost < a.cost || b.error < a.error);
            });
            if (!beaten) expected.emplace(a.cost, a.error);
        }
        for (const std::size_t k : front) CHECK(found.emplace(points[k].cost, points[k].error).second);
        CHECK(found == expected);
        CHECK(std::is_sorted(front.begin(), front.end(), [&](std::size_t a, std::size_t b) { return points[a].cost < points[b].cost; }));
    }
}

TEST_CASE("a sweep varies one axis at a time, or with full all of them, and repeats nothing") {
    SweepAxes axes;
    axes.methods = {"linear", "cone", "relaxed", "cone-normal"};
    axes.steps = {8, 16};
    const std::vector<PlannedCandidate> planned = plan_sweep(axes);
    std::map<std::string, std::size_t> of_method;
    std::set<std::string> ids;
    for (const PlannedCandidate& next : planned) {
        ++of_method[std::string(next.method->word)];
        CHECK(ids.insert(id_of(next.candidate)).second);
    }
    CHECK(of_method["linear"] == 2 * (1 + 2 + 2));           // bits, resolutions
    CHECK(of_method["cone"] == 2 * (1 + 2 + 2 + 2 + 3));     // tolerances and encodings, too
    CHECK(of_method["relaxed"] == 2 * (1 + 2 + 2 + 2 + 3 + 1)); // and refinements
    CHECK(of_method["cone-normal"] == 2 * (1 + 2 + 2 + 2));
    axes.full = true, axes.methods = {"relaxed"};
    CHECK(plan_sweep(axes).size() == 2 * 2 * 4 * 3 * 3 * 3);
    axes.methods = {}, axes.full = false;
    std::set<std::string_view> methods;
    for (const PlannedCandidate& next : plan_sweep(axes)) methods.insert(next.method->word);
    CHECK(methods.size() == 13);
}

namespace {

Result<Measurement> figures_of(const Candidate& candidate) {
    Measurement figures;
    figures.rays = 5, figures.error_mean = 1.0 / (candidate.march.steps + 3), figures.steps_mean = candidate.march.steps;
    return figures;
}

std::string key_of(const std::string& id) { return "k" + id; }

std::vector<std::string> texts_of(const SweepResult& result) {
    std::vector<std::string> texts;
    for (const MeasuredCandidate& point : result.candidates) texts.push_back(id_of(point.planned.candidate) + to_json(point.figures).dump());
    return texts;
}

} // namespace

TEST_CASE("a sweep that is cut off anywhere goes on to the result of one that is not") {
    SweepAxes axes;
    axes.methods = {"linear", "cone"}, axes.steps = {8, 16, 32};
    const std::vector<PlannedCandidate> planned = plan_sweep(axes);
    TemporaryFolder whole_folder, folder;
    Result<SweepRecord> whole = SweepRecord::open(whole_folder.path().string());
    REQUIRE(whole);
    const Result<SweepResult> undisturbed = run_sweep(planned, *whole, key_of, figures_of);
    REQUIRE(undisturbed);
    CHECK(undisturbed->measured_anew == planned.size());

    std::size_t measured = 0;
    for (const std::size_t stop : {1, 4, 4, 7}) {
        Result<SweepRecord> record = SweepRecord::open(folder.path().string());
        REQUIRE(record);
        std::size_t left = stop;
        const Result<SweepResult> cut = run_sweep(planned, *record, key_of, [&](const Candidate& candidate) -> Result<Measurement> {
            if (left-- == 0) return fail(ErrorCode::internal, std::string("cut"));
            ++measured;
            return figures_of(candidate);
        });
        CHECK_FALSE(cut);
        std::ofstream(folder.path() / "measurements.jsonl", std::ios::app) << "{\"key\": \"torn"; // as a power cut leaves it
    }
    CHECK(measured == 16);
    {
        Result<SweepRecord> record = SweepRecord::open(folder.path().string());
        REQUIRE(record);
        CHECK_FALSE(SweepRecord::open(folder.path().string())); // one run at a time
        const Result<SweepResult> finished = run_sweep(planned, *record, key_of, figures_of);
        REQUIRE(finished);
        CHECK(finished->measured_anew == planned.size() - 16);
        CHECK(texts_of(*finished) == texts_of(*undisturbed));
    }
    Result<SweepRecord> record = SweepRecord::open(folder.path().string());
    REQUIRE(record);
    const Result<SweepResult> again = run_sweep(planned, *record, key_of, figures_of);
    REQUIRE(again);
    CHECK(again->measured_anew == 0);
    CHECK(texts_of(*again) == texts_of(*undisturbed));
}

TEST_CASE("a record of something else is refused") {
    TemporaryFolder folder;
    std::ofstream(folder.path() / "measurements.jsonl") << "{\"key\": \"a\"}\n";
    const Result<SweepRecord> record = SweepRecord::open(folder.path().string());
    REQUIRE_FALSE(record);
    CHECK(record.error().code == ErrorCode::bad_data);
    CHECK(record.error().message.find("line 1") != std::string::npos);
}

// Choosing, with measurements that were made up.

#include "cli/advise/advice_search.h"
#include "cli/advise/bake_command_text.h"
#include "cli/advise/sample_tile.h"
#include "tests/unit/tradeoff/source_fields.h"

#include <algorithm>
#include <random>
#include <set>

using namespace reliefbake;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

const std::function<bool(const Representation&)> anything = [](const Representation&) { return true; };

Budget budget_of(double missed, double error, int steps = 64, double bytes = endless) { return {missed, error, steps, bytes}; }

AdvicePlan plan_of(const Budget& budget, ShaderTarget target = ShaderTarget::glsl) { return plan_advice(256, 256, budget, target, anything); }

/// Trials of random candidates with few distinct figures, so that ties are common.
std::vector<Trial> random_trials(std::mt19937& random) {
    std::vector<Trial> trials;
    const std::vector<Way> ways = plan_of(budget_of(1, 1)).ways;
    for (int k = 0; k < 40; ++k) {
        const Way& way = ways[random() % ways.size()];
        Trial trial{way.marches[random() % way.marches.size()], {}};
        const bool again = std::any_of(trials.begin(), trials.end(), [&](const Trial& other) { return other.candidate == trial.candidate; });
        if (again) continue;
        Measurement& f = trial.figures;
        f.rays = 1000, f.missed = double(random() % 5) / 100, f.error_mean = double(1 + random() % 8) / 1000, f.steps_max = double(8 << random() % 5);
        f.bytes_per_texel = double(1 + random() % 3), f.fetches_mean = double(10 + random() % 3), f.instructions = double(random() % 3) * 100;
        trials.push_back(trial);
    }
    return trials;
}

Budget random_budget(std::mt19937& random) {
    return budget_of(double(random() % 5) / 100, double(1 + random() % 8) / 1000, 8 << random() % 5, double(1 + random() % 3));
}

int rounds_of(const March& march) { return march.steps + march.refinements + (technique_info(march.technique).steps == TechniqueInfo::Steps::linear ? 1 : 0); }

/// Made-up figures: longer marches of more bytes err less; a hash of the id makes some ways bad.
Measurement figures_of(const Candidate& candidate, unsigned seed, double harder, int level_lost = 9) {
    std::mt19937 random(unsigned(std::hash<std::string>()(id_of(candidate.map) + std::to_string(int(candidate.march.technique)))) ^ seed);
    const int rounds = rounds_of(candidate.march);
    Measurement f;
    f.rays = 1000;
    f.bytes_per_texel = source_bytes_per_texel(candidate, 256, 256);
    f.error_mean = harder * (0.02 + double(random() % 1000) / 1000) / rounds, f.missed = random() % 3 ? 0 : harder * double(random() % 100) / 1000;
    if (candidate.march.technique == Technique::max_mip) f.missed = 0; // surfaces lose nothing, unless level_lost says so
    if (candidate.map.level >= level_lost) f.missed = 0.5;
    f.fetches_mean = rounds * (1 + double(random() % 100) / 100) / 2, f.steps_max = rounds;
    return f;
}

Advice searched(const std::vector<Way>& ways, const Budget& budget, unsigned seed, double harder_to_prove = 1, int level_lost = 9) {
    Measurers measurers;
    measurers.screen = [=](const Candidate& candidate) -> Result<Measurement> { return figures_of(candidate, seed, 1, level_lost); };
    measurers.prove = [=](const Candidate& candidate) -> Result<Measurement> { return figures_of(candidate, seed, harder_to_prove, level_lost); };
    const Result<Advice> advice = search_advice(ways, budget, measurers);
    REQUIRE(advice);
    return *advice;
}

} // namespace

TEST_CASE("a choice never breaks a limit, is the cheapest, and does not depend on the order of trials") {
    std::mt19937 random(1);
    int answered = 0;
    for (int round = 0; round < 2000; ++round) {
        std::vector<Trial> trials = random_trials(random);
        const Budget budget = random_budget(random);
        const Choice choice = choose(trials, budget);
        CHECK(choice.answer.has_value() == std::any_of(trials.begin(), trials.end(), [&](const Trial& t) { return meets(t.figures, budget); }));
        CHECK(choice.answer.has_value() != choice.nearest.has_value());
        for (const std::optional<std::size_t>& index : {choice.answer, choice.runner_up}) {
            if (!index) continue;
            const Measurement& f = trials[*index].figures;
            CHECK((f.missed <= budget.max_missed && f.error_mean <= budget.max_error && f.steps_max <= budget.steps && f.bytes_per_texel <= budget.bytes_per_texel));
        }
        for (const Trial& trial : trials) {
            if (choice.answer && meets(trial.figures, budget)) CHECK_FALSE(is_cheaper(trial, trials[*choice.answer]));
            if (choice.nearest) CHECK(excess_of(trial.figures, budget, Margin::sure) >= excess_of(trials[*choice.nearest].figures, budget, Margin::sure));
        }
        if (choice.runner_up) CHECK_FALSE(is_same_way(trials[*choice.answer].candidate, trials[*choice.runner_up].candidate));
        answered += choice.answer.has_value();

        std::vector<Trial> shuffled = trials;
        std::shuffle(shuffled.begin(), shuffled.end(), random);
        const Choice again = choose(shuffled, budget);
        const auto same = [&](const std::optional<std::size_t>& a, const std::optional<std::size_t>& b) {
            return a.has_value() == b.has_value() && (!a || trials[*a].candidate == shuffled[*b].candidate);
        };
        CHECK((same(choice.answer, again.answer) && same(choice.runner_up, again.runner_up) && same(choice.nearest, again.nearest)));
    }
    CHECK((answered > 500 && answered < 1999));
}

TEST_CASE("a looser budget never makes the choice dearer") {
    std::mt19937 random(2);
    for (int round = 0; round < 2000; ++round) {
        const std::vector<Trial> trials = random_trials(random);
        const Budget tight = random_budget(random), other = random_budget(random);
        const Budget loose{std::max(tight.max_missed, other.max_missed), std::max(tight.max_error, other.max_error), std::max(tight.steps, other.steps),
                           std::max(tight.bytes_per_texel, other.bytes_per_texel)};
        const Choice before = choose(trials, tight), after = choose(trials, loose);
        if (!before.answer) continue;
        REQUIRE(after.answer);
        CHECK_FALSE(is_cheaper(trials[*before.answer], trials[*after.answer]));
    }
}

TEST_CASE("ties are broken by reads, counted instructions, error, and the id at last") {
    const std::vector<Way> ways = plan_of(budget_of(1, 1)).ways;
    Trial a{ways[0].marches[0], {}}, b{ways[1].marches[0], {}};
    a.figures.rays = b.figures.rays = 1;
    CHECK(is_cheaper(a, b) != is_cheaper(b, a));
    CHECK(is_cheaper(a, b) == (id_of(a.candidate) < id_of(b.candidate)));
    a.figures.error_mean = 0.1;
    CHECK(is_cheaper(b, a));
    a.figures.instructions = 900; // not counted is dearer than any number
    CHECK(is_cheaper(a, b));
    a.figures.fetches_mean = 2, b.figures.fetches_mean = 1;
    CHECK(is_cheaper(b, a));
    b.figures.bytes_per_texel = 1;
    CHECK(is_cheaper(a, b));
    CHECK_FALSE(is_cheaper(a, a));
}

TEST_CASE("figures of no ray, and what is no number, meet nothing") {
    Measurement f;
    CHECK_FALSE(meets(f, budget_of(1, 1)));
    f.rays = 100;
    CHECK(meets(f, budget_of(0, 1)));
    CHECK(excess_of(f, budget_of(0, 1), Margin::sure) == 1);
    f.missed = 0.01; // one ray, where none may be missed
    CHECK_FALSE(meets(f, budget_of(0, 1)));
    CHECK(excess_of(f, budget_of(0, 1), Margin::none) == 1);
    f.missed = 0.06;
    CHECK(excess_of(f, budget_of(0, 1), Margin::none) == Approx(3));
    CHECK(excess_of(f, budget_of(0.04, 1), Margin::none) == Approx(1.5));
    f.bytes_per_texel = 8;
    CHECK(excess_of(f, budget_of(0.04, 1, 64, 2), Margin::none) == Approx(4));
    f.missed = 0, f.error_mean = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(meets(f, budget_of(1, 1)));
    CHECK(excess_of(f, budget_of(1, 1), Margin::none) == endless);
}

TEST_CASE("what was found near a limit is over it, by as much as other rays may differ") {
    Measurement f;
    f.rays = 10000, f.missed = 0.0049;
    const Budget budget = budget_of(0.005, 0.1);
    CHECK(faults_of(f, budget, Margin::none).empty());
    REQUIRE(faults_of(f, budget, Margin::sure).size() == 1);
    CHECK(text_of(faults_of(f, budget, Margin::sure)[0]) == "missed 0.49 % (0.72 % by other rays) > 0.5 %");
    f.missed = 0, f.error_mean = 0.099, f.error_deviation = 0.02;
    CHECK(meets(f, budget));
    f.error_deviation = 0.2;
    REQUIRE(faults_of(f, budget, Margin::sure).size() == 1);
    CHECK(text_of(faults_of(f, budget, Margin::sure)[0]) == "mean error 0.099 (0.11 by other rays) > 0.1");

    // The law itself, of shares drawn anew: what meets a limit once is found over it by other rays once in a hundred times at most.
    std::mt19937 random(3);
    int met = 0, over = 0;
    for (int round = 0; round < 20000; ++round) {
        std::binomial_distribution<int> rays(20000, 0.003 + 0.002 * double(round % 100) / 100);
        f = {}, f.rays = 20000, f.missed = rays(random) / 20000.0;
        if (!meets(f, budget)) continue;
        ++met, over += rays(random) / 20000.0 > budget.max_missed;
    }
    CHECK((met > 1000 && over * 100 <= met));
}

TEST_CASE("a search ends with what is proven, whatever the screen says") {
    int answered = 0, misled = 0, untried = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const double harder = seed % 3 == 0 ? 1 : seed % 3 == 1 ? 3 : 0.5; // the proof against the screen
        const Budget budget = budget_of(0.02 * (seed % 4), 0.002 + 0.001 * (seed % 7), 16 << seed % 3, seed % 2 ? endless : 6);
        const std::vector<Way> ways = plan_of(budget).ways;
        const Advice advice = searched(ways, budget, seed, harder);
        for (const std::optional<std::size_t>& index : {advice.choice.answer, advice.choice.runner_up}) {
            if (!index) continue;
            CHECK(advice.measured[*index].proven);
            CHECK(meets(advice.trials[*index].figures, budget));
        }
        if (advice.choice.nearest) {
            CHECK(advice.measured[*advice.choice.nearest].proven);
            CHECK_FALSE(meets(advice.trials[*advice.choice.nearest].figures, budget));
        }
        std::set<std::pair<std::string, bool>> seen;
        for (std::size_t k = 0; k < advice.trials.size(); ++k) {
            CHECK(seen.emplace(id_of(advice.trials[k].candidate), advice.measured[k].proven).second); // each once
            misled += !advice.measured[k].proven && meets(advice.trials[k].figures, budget) && !meets(figures_of(advice.trials[k].candidate, seed, harder), budget);
        }
        if (advice.choice.answer) {
            for (const Way* way : advice.untried) CHECK(way->bytes_per_texel > advice.trials[*advice.choice.answer].figures.bytes_per_texel);
            untried += !advice.untried.empty();
        } else {
            CHECK(advice.untried.empty());
        }
        answered += advice.choice.answer.has_value();
    }
    CHECK((answered > 50 && misled > 50 && untried > 20));
}

TEST_CASE("where the screen is right, the search finds what measuring everything finds, and a looser budget is never dearer") {
    for (unsigned seed = 0; seed < 100; ++seed) {
        std::optional<Trial> last;
        for (const double error : {0.001, 0.002, 0.004, 0.008, 0.02}) {
            const Budget budget = budget_of(0.03, error);
            const std::vector<Way> ways = plan_of(budget).ways;
            const Advice advice = searched(ways, budget, seed);
            std::vector<Trial> all;
            for (const Way& way : ways)
                for (const Candidate& candidate : way.marches) all.push_back({candidate, figures_of(candidate, seed, 1)});
            const Choice best = choose(all, budget);
            REQUIRE(best.answer.has_value() == advice.choice.answer.has_value());
            if (!best.answer) continue;
            const Trial& answer = advice.trials[*advice.choice.answer];
            CHECK(id_of(all[*best.answer].candidate) == id_of(answer.candidate));
            if (last) CHECK_FALSE(is_cheaper(*last, answer));
            last = answer;
        }
    }
}

TEST_CASE("a surface that loses too much is measured once and given up, but never the finest") {
    for (const int lost : {1, 2, 0}) {
        const Budget budget = budget_of(0.01, 0.004);
        const std::vector<Way> ways = plan_of(budget).ways;
        const Advice advice = searched(ways, budget, 3, 1, lost);
        std::size_t given_up = 0;
        for (const Advice::Probed& probed : advice.surfaces) {
            CHECK(probed.given_up == (probed.surface.level >= lost));
            CHECK((!probed.proven || !probed.given_up)); // the screen saw it
            given_up += probed.given_up;
        }
        CHECK((given_up > 0 && !advice.given_up.empty()));
        for (const Trial& trial : advice.trials) CHECK((trial.candidate.map.level < lost || surface_of(trial.candidate) == StoredSurface{BitDepth::float32, 0}));
        CHECK(advice.choice.answer.has_value() == (lost > 0));
        CHECK(advice.choice.nearest.has_value() == (lost == 0));
    }
}

TEST_CASE("an error of the measurers ends the search") {
    const Budget budget = budget_of(0, 0.01);
    Measurers measurers;
    measurers.screen = measurers.prove = [](const Candidate&) -> Result<Measurement> { return fail(ErrorCode::bad_data, "no"); };
    const Result<Advice> advice = search_advice(plan_of(budget).ways, budget, measurers);
    REQUIRE_FALSE(advice);
    CHECK(advice.error().code == ErrorCode::bad_data);
}

TEST_CASE("a plan holds what the budget, the target and the output allow, by bytes") {
    const Budget budget = budget_of(0.01, 0.01, 30, 8);
    for (const ShaderTarget target : {ShaderTarget::glsl, ShaderTarget::glsl_es, ShaderTarget::hlsl}) {
        std::set<std::string> ids, methods;
        std::set<BitDepth> bits;
        double last = 0;
        for (const Way& way : plan_of(budget, target).ways) {
            CHECK((way.bytes_per_texel >= last && way.bytes_per_texel <= 8));
            last = way.bytes_per_texel;
            methods.insert(std::string(way.method->word)), bits.insert(way.marches.front().map.bits);
            for (const Candidate& candidate : way.marches) {
                CHECK(check_candidate(candidate));
                CHECK(ids.insert(id_of(candidate)).second);
                CHECK(rounds_of(candidate.march) <= 30);
                CHECK(source_bytes_per_texel(candidate, 256, 256) == way.bytes_per_texel);
            }
            CHECK(rounds_of(way.marches.front().march) == 30);
        }
        CHECK((methods.count("linear") + methods.count("max-mip") + methods.count("exact-finish")) == (target == ShaderTarget::hlsl ? 0 : 3));
        CHECK(methods.count("sectors-8") == 1); // at 1/2
        CHECK(bits == (target == ShaderTarget::glsl_es ? std::set{BitDepth::unorm8, BitDepth::half} : std::set{BitDepth::unorm8, BitDepth::unorm16}));
    }
    const AdvicePlan least = plan_of(budget_of(0.01, 0.01, 30, 0.1));
    CHECK(least.ways.empty());
    CHECK(least.too_large.front().bytes_per_texel == 3.0 / 16);
    CHECK(plan_advice(256, 256, budget, ShaderTarget::glsl, [](const Representation& map) { return map.bits == BitDepth::half; }).ways.size() > 10);
    CHECK(plan_advice(1, 1, budget, ShaderTarget::glsl, anything).ways.front().marches.front().map.level == 0);
    CHECK(march_lengths(30) == std::vector{30, 16, 8, 4});
    CHECK(march_lengths(2) == std::vector{2});
}

TEST_CASE("where no ray may be missed, only what promises that is tried") {
    std::set<std::string> methods;
    for (const Way& way : plan_of(budget_of(0, 0.01)).ways) {
        methods.insert(std::string(way.method->word));
        CHECK(way.marches.front().map.level == 0);
    }
    CHECK(methods == std::set<std::string>{"cone", "relaxed", "sectors-4", "sectors-8", "cone-normal", "stacked", "max-mip", "exact-finish"});
}

TEST_CASE("commands say what is baked") {
    std::set<std::string> commands;
    for (const Way& way : plan_of(budget_of(1, 1)).ways) commands.insert(bake_command_text(way.marches.front().map));
    for (const char* command : {"cone --channels normal,depth --bits 8 --level 2", "cone --bits 16 --encoding ratio", "cone --kind relaxed --relaxed top --bits 8 --encoding sqrt", "cone-normal --bits float",
                                "cone --kind hybrid --delta 0.05 --bits 8 --encoding sqrt --level 1", "acm --sectors 8 --bits 8 --encoding sqrt", "cone-stack --levels 3 --bits 16 --encoding ratio"})
        CHECK(commands.count(command) == 1);
    CHECK(march_text({Technique::relaxed, false, 15, 8}) == "--technique relaxed --steps 15 --binary-steps 8");
    CHECK(march_text({Technique::cone, true, 30, 0}) == "--technique cone --exact-finish --steps 30");
}

TEST_CASE("a tile mirrors the middle of a field, and its cones' caps grow with it") {
    const BakeSource source = hills_with_posts(40);
    const Result<HeightField> tile = sample_tile(*source.field, 8, "field");
    REQUIRE(tile);
    CHECK((tile->grid().width == 16 && tile->grid().wrap_x == Wrap::repeat && tile->grid().wrap_y == Wrap::repeat));
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const int u = x < 8 ? x : 15 - x, v = y < 8 ? y : 15 - y;
            CHECK(tile->heights()(x, y) == source.field->heights()(16 + u, 16 + v));
        }
    Candidate candidate;
    CHECK(on_tile(candidate, 2.5).map.cone.ratio_max == 2.5f);
    candidate.map.cone.ratio_max = std::numeric_limits<float>::infinity();
    CHECK(std::isinf(on_tile(candidate, 2.5).map.cone.ratio_max));
}

#include "cli/tradeoff/measure_candidate.h"
#include "tests/unit/tradeoff/source_fields.h"

using namespace reliefbake;

namespace {

constexpr double depth_scale = 0.1;

JudgeOptions few_rays(int threads = 1) {
    JudgeOptions options;
    options.rays = 7000, options.repeat = 1, options.threads = threads;
    return options;
}

Candidate cone_candidate(int steps, bool exact_finish = false) {
    Candidate candidate;
    candidate.march = {Technique::cone, exact_finish, steps, 0};
    return candidate;
}

Candidate height_candidate(Technique technique, int steps, int refinements = 0) {
    Candidate candidate;
    candidate.map.kind = "height";
    candidate.march = {technique, false, steps, refinements};
    return candidate;
}

Measurement measured(CandidateMeter& meter, const Candidate& candidate) {
    Result<Measurement> result = meter.measure(candidate);
    INFO(id_of(candidate) << ": " << (result ? "" : result.error().message));
    REQUIRE(result);
    return *result;
}

CandidateMeter meter_of(const BakeSource& source, const JudgeOptions& options = few_rays()) {
    Result<CandidateMeter> meter = CandidateMeter::create(source, depth_scale, options);
    REQUIRE(meter);
    return std::move(*meter);
}

} // namespace

TEST_CASE("exact marches miss nothing, at any depth of bits, and err by no more than their codes") {
    const WrapChoice wrap = GENERATE(WrapChoice::repeat, WrapChoice::clamp);
    const BakeSource source = hills_with_posts(48, wrap);
    CandidateMeter meter = meter_of(source);
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32}) {
        for (Candidate candidate : {height_candidate(Technique::max_mip, 512), cone_candidate(512, true), cone_candidate(4000)}) {
            candidate.map.bits = bits;
            const Measurement result = measured(meter, candidate);
            CAPTURE(id_of(candidate));
            CHECK(result.rays > 3000); // a clamped map leaves some pixels empty
            CHECK(result.missed == 0);
            CHECK(result.early == 0);
            CHECK(result.error_max <= few_rays().missed_depth);
            CHECK(result.dissimilarity < (bits == BitDepth::float32 ? 0.001 : 0.2));
        }
    }
}

TEST_CASE("a linear search errs less with more steps, costs more, and halving narrows what it found") {
    const BakeSource source = hills_with_posts(48);
    CandidateMeter meter = meter_of(source);
    Measurement last = measured(meter, height_candidate(Technique::linear, 4));
    CHECK(last.missed > 0.05);
    for (const int steps : {16, 64, 256, 1024}) {
        const Measurement next = measured(meter, height_candidate(Technique::linear, steps));
        CAPTURE(steps);
        CHECK(next.error_mean < last.error_mean);
        CHECK(next.missed <= last.missed);
        CHECK(next.dissimilarity < last.dissimilarity);
        CHECK(next.fetches_mean > last.fetches_mean);
        CHECK(next.steps_mean > last.steps_mean);
        last = next;
    }
    const Measurement halved = measured(meter, height_candidate(Technique::binary, 64, 10));
    const Measurement linear = measured(meter, height_candidate(Technique::linear, 64));
    CHECK(halved.mse < linear.mse / 10);
    CHECK(halved.steps_mean == Approx(linear.steps_mean + 10));
    CHECK(halved.refining_steps_mean == Approx(10));
    CHECK(linear.refining_steps_mean == 0);
    CHECK(halved.instructions > linear.instructions);
}

TEST_CASE("fewer texels and fewer bits are errors, and save bytes") {
    const BakeSource source = hills_with_posts(48);
    CandidateMeter meter = meter_of(source);
    Candidate fine = height_candidate(Technique::max_mip, 512);
    Candidate coarse = fine, few = fine;
    coarse.map.level = 1;
    few.map.bits = BitDepth::unorm8;
    const Measurement best = measured(meter, fine), halved = measured(meter, coarse), eight = measured(meter, few);
    CHECK(halved.error_mean > 10 * best.error_mean); // the posts are gone
    CHECK(halved.missed > 0.01);
    CHECK(halved.bytes == Approx(best.bytes / 4));
    CHECK(halved.bytes_per_texel == Approx(best.bytes_per_texel / 4));
    CHECK(eight.error_mean > 2 * best.error_mean);
    CHECK(eight.bytes == Approx(best.bytes - 3 * 48 * 48));
}

TEST_CASE("cones that are too wide are missed hits") {
    const BakeSource source = hills_with_posts(48);
    RepresentationBaker baker(source, depth_scale, 1);
    const Result<const BakedRepresentation*> baked = baker.bake({});
    REQUIRE(baked);
    Result<Judge> judge = Judge::create(quantise_depth(*source.field, BitDepth::float32), depth_scale, few_rays());
    REQUIRE(judge);
    REQUIRE(judge->load((*baked)->map));
    const Result<Measurement> right = judge->measure({Technique::cone, false, 512, 0});
    REQUIRE(right);
    CHECK(right->missed == 0);

    ReliefMap widened = (*baked)->map;
    widened.info.cone_max *= 2;
    REQUIRE(judge->load(widened));
    const Result<Measurement> wrong = judge->measure({Technique::cone, false, 512, 0});
    REQUIRE(wrong);
    CHECK(wrong->missed > 0.001);
}

TEST_CASE("figures depend neither on threads nor on the order of candidates") {
    const BakeSource source = hills_with_posts(48);
    CandidateMeter one = meter_of(source, few_rays(1)), two = meter_of(source, few_rays(2));
    Candidate relaxed = cone_candidate(20);
    relaxed.map.cone.family = ConeFamily::relaxed, relaxed.march = {Technique::relaxed, false, 12, 6};
    Candidate coded = cone_candidate(20);
    coded.map.encoding = ConeEncoding::ratio;
    const std::vector<Candidate> candidates = {cone_candidate(20), coded, relaxed, height_candidate(Technique::linear, 20)};
    std::vector<Measurement> forwards, backwards;
    for (auto c = candidates.begin(); c != candidates.end(); ++c) forwards.push_back(measured(one, *c));
    for (auto c = candidates.rbegin(); c != candidates.rend(); ++c) backwards.push_back(measured(two, *c));
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const Measurement &a = forwards[k], &b = backwards[candidates.size() - 1 - k];
        CAPTURE(id_of(candidates[k]));
        CHECK(a.missed == b.missed);
        CHECK(a.error_mean == b.error_mean);
        CHECK(a.error_deviation == b.error_deviation);
        CHECK(a.error_p99 == b.error_p99);
        CHECK(a.mse == b.mse);
        CHECK(a.fetches_mean == b.fetches_mean);
        CHECK(a.bytes == b.bytes);
    }
}

TEST_CASE("a resolution that the map does not have is refused") {
    const BakeSource source = hills_with_posts(16);
    CandidateMeter meter = meter_of(source);
    Candidate candidate = cone_candidate(20);
    candidate.map.level = 5;
    const Result<Measurement> result = meter.measure(candidate);
    REQUIRE_FALSE(result);
    CHECK(result.error().code == ErrorCode::usage);
}

#include "cli/tradeoff/candidate.h"

#include <catch2/catch.hpp>

#include <limits>
#include <set>

using namespace reliefbake;

namespace {

Candidate relaxed_candidate() {
    Candidate candidate;
    candidate.map.cone.family = ConeFamily::relaxed;
    candidate.march = {Technique::relaxed, false, 15, 8};
    return candidate;
}

} // namespace

TEST_CASE("an id says all of a candidate in letters of a file's name") {
    CHECK(id_of(relaxed_candidate()) == "relaxed_sqrt_16_t0.001_m1_res1_relaxed_n15_r8");
    Candidate plain;
    plain.map.kind = "height", plain.map.bits = BitDepth::half, plain.map.level = 2;
    plain.march = {Technique::linear, false, 32, 8};
    CHECK(id_of(plain) == "height_half_res0.25_linear_n32");

    // Whatever is changed, the id changes; what the candidate does not use does not count.
    std::set<std::string> ids{id_of(relaxed_candidate())};
    std::size_t changes = 1;
    const auto differs = [&](auto change) {
        Candidate other = relaxed_candidate();
        change(other);
        ids.insert(id_of(other));
        ++changes;
    };
    differs([](Candidate& c) { c.map.kind = "acm", c.map.planes = 4; });
    differs([](Candidate& c) { c.map.kind = "acm", c.map.planes = 8; });
    differs([](Candidate& c) { c.map.kind = "cone-stack", c.map.planes = 4; });
    differs([](Candidate& c) { c.map.kind = "cone-pieces", c.map.planes = 4; });
    differs([](Candidate& c) { c.map.cone.family = ConeFamily::conservative; });
    differs([](Candidate& c) { c.map.cone.family = ConeFamily::hybrid, c.map.cone.hybrid_delta = 0.05f; });
    differs([](Candidate& c) { c.map.cone.family = ConeFamily::hybrid, c.map.cone.hybrid_delta = 0.1f; });
    differs([](Candidate& c) { c.map.cone.rays = RelaxedRays::top; });
    differs([](Candidate& c) { c.map.cone.rays = RelaxedRays::slope, c.map.cone.relaxed_slope = 4; });
    differs([](Candidate& c) { c.map.cone.lookup = ConeLookup::cell; });
    differs([](Candidate& c) { c.map.cone.metric = Metric::l1; });
    differs([](Candidate& c) { c.map.cone.tolerance = 0.01f; });
    differs([](Candidate& c) { c.map.cone.ratio_max = std::numeric_limits<float>::infinity(); });
    differs([](Candidate& c) { c.map.encoding = ConeEncoding::normal; });
    differs([](Candidate& c) { c.map.bits = BitDepth::unorm8; });
    differs([](Candidate& c) { c.map.level = 1; });
    differs([](Candidate& c) { c.march.technique = Technique::relaxed_secant; });
    differs([](Candidate& c) { c.march.steps = 16; });
    differs([](Candidate& c) { c.march.refinements = 7; });
    differs([](Candidate& c) { c.march.technique = Technique::cone, c.march.exact_finish = true; });
    CHECK(ids.size() == changes);
    for (const std::string& id : ids)
        CHECK(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-_") == std::string::npos);
}

TEST_CASE("bytes count every channel") {
    Candidate candidate = relaxed_candidate();
    CHECK(bytes_per_texel(candidate) == 8);
    candidate.map.kind = "acm", candidate.map.planes = 8;
    CHECK(bytes_per_texel(candidate) == 22);
    candidate.map.kind = "height", candidate.map.bits = BitDepth::unorm8;
    candidate.march = {Technique::linear, false, 8, 0};
    CHECK(bytes_per_texel(candidate) == 3);
    candidate.march.technique = Technique::max_mip;
    CHECK(bytes_per_texel(candidate) == Approx(3 + 16.0 / 3));
}

TEST_CASE("candidates that cannot be are refused") {
    Candidate candidate = relaxed_candidate();
    CHECK(check_candidate(candidate));
    candidate.march.technique = Technique::cone;
    CHECK_FALSE(check_candidate(candidate));
    candidate = relaxed_candidate(), candidate.march.steps = 0;
    CHECK_FALSE(check_candidate(candidate));
    candidate = relaxed_candidate(), candidate.march.exact_finish = true;
    CHECK_FALSE(check_candidate(candidate));
    candidate = relaxed_candidate(), candidate.map.kind = "height";
    CHECK_FALSE(check_candidate(candidate));
    candidate = relaxed_candidate(), candidate.map.cone.ratio_max = std::numeric_limits<float>::infinity();
    CHECK_FALSE(check_candidate(candidate));
    candidate.map.encoding = ConeEncoding::normal;
    CHECK(check_candidate(candidate));
    candidate.map.encoding = ConeEncoding::radius;
    CHECK_FALSE(check_candidate(candidate));
    candidate.map.bits = BitDepth::half;
    CHECK(check_candidate(candidate));
}

// The same bits for every thread count and SIMD width.

#include "bake/cone.h"
#include "bake/shared_pyramids.h"
#include "bake/simd.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <functional>
#include <vector>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

bool same_bits(const Image<float>& a, const Image<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

} // namespace

TEST_CASE("one and many threads, scalar and every SIMD width give the same bits") {
    REQUIRE(available_simd().size() >= 3); // automatic, scalar and one real instruction set
    for (const std::string& name : {std::string("hill"), std::string("stairs"), std::string("noise")})
        for (Metric metric : {Metric::l2, Metric::l1})
            for (Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
                const TexelGrid grid = grid_of(203, 131, wrap);
                const DepthMap depth = name == "noise" ? noise(grid, 3) : adversarial(grid, name);
                ConeOptions options;
                options.metric = metric;
                options.threads = 1;
                use_simd(Simd::automatic);
                const Image<float> reference = bake_cones(depth, options).ratio;
                for (Simd simd : available_simd())
                    for (int threads : {1, 2, 5}) {
                        CAPTURE(name, to_string(simd), threads);
                        use_simd(simd);
                        options.threads = threads;
                        REQUIRE(same_bits(bake_cones(depth, options).ratio, reference));
                    }
                use_simd(Simd::automatic);
            }
}

TEST_CASE("bakes that share pyramids give the bits of bakes that do not, in any order") {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const DepthMap depth = noise(grid_of(143, 91, wrap), 5);
        std::vector<std::function<std::vector<ConeMap>(SharedPyramids*)>> bakes;
        const auto add = [&](ConeFamily family, RelaxedRays rays, Metric metric) {
            ConeOptions options;
            options.family = family, options.rays = rays, options.metric = metric, options.hybrid_delta = 0.1f, options.relaxed_slope = 3;
            bakes.push_back([=, &depth](SharedPyramids* shared) { return std::vector<ConeMap>{bake_cones(depth, options, nullptr, shared)}; });
            if (family == ConeFamily::hybrid) return;
            bakes.push_back([=, &depth](SharedPyramids* shared) { return bake_sector_cones(depth, 4, options, nullptr, shared); });
            if (metric == Metric::l2)
                bakes.push_back([=, &depth](SharedPyramids* shared) { return bake_sector_cones(depth, 8, options, nullptr, shared); });
        };
        for (const Metric metric : {Metric::l2, Metric::l1}) {
            add(ConeFamily::conservative, RelaxedRays::strict, metric);
            for (const RelaxedRays rays : {RelaxedRays::strict, RelaxedRays::top, RelaxedRays::slope}) add(ConeFamily::relaxed, rays, metric);
            add(ConeFamily::hybrid, RelaxedRays::strict, metric);
        }
        bakes.push_back([&depth](SharedPyramids* shared) { return bake_stacked_cones(depth, 3, {}, nullptr, shared); });
        SharedPyramids forwards, backwards;
        for (std::size_t k = 0; k < bakes.size(); ++k) {
            const std::size_t last = bakes.size() - 1 - k;
            const std::vector<ConeMap> alone = bakes[k](nullptr), shared = bakes[k](&forwards);
            const std::vector<ConeMap> alone_last = bakes[last](nullptr), shared_last = bakes[last](&backwards);
            for (std::size_t plane = 0; plane < alone.size(); ++plane) REQUIRE(same_bits(alone[plane].ratio, shared[plane].ratio));
            for (std::size_t plane = 0; plane < alone_last.size(); ++plane)
                REQUIRE(same_bits(alone_last[plane].ratio, shared_last[plane].ratio));
        }
    }
}

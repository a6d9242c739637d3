// The same bits for every thread count and SIMD width.

#include "bake/cone.h"
#include "bake/simd.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cstring>

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

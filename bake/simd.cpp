#include "bake/simd.h"

#include <cassert>
#include <cstdint>

#include <hwy/targets.h>

namespace reliefbake {
namespace {

std::int64_t target_of(Simd choice) {
    switch (choice) {
    case Simd::scalar: return HWY_SCALAR;
    case Simd::ssse3: return HWY_SSSE3;
    case Simd::sse4: return HWY_SSE4;
    case Simd::avx2: return HWY_AVX2;
    case Simd::avx512: return HWY_AVX3;
    case Simd::automatic: break;
    }
    return 0; // Highway's word for "no restriction"
}

} // namespace

std::vector<Simd> available_simd() {
    use_simd(Simd::automatic);
    const std::int64_t supported = hwy::SupportedTargets();
    std::vector<Simd> out{Simd::automatic};
    for (Simd choice : {Simd::scalar, Simd::ssse3, Simd::sse4, Simd::avx2, Simd::avx512})
        if ((supported & target_of(choice)) != 0) out.push_back(choice);
    return out;
}

void use_simd(Simd choice) {
    hwy::SetSupportedTargetsForTest(target_of(choice));
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

const char* to_string(Simd choice) {
    switch (choice) {
    case Simd::automatic: return "automatic";
    case Simd::scalar: return "scalar";
    case Simd::ssse3: return "ssse3";
    case Simd::sse4: return "sse4";
    case Simd::avx2: return "avx2";
    case Simd::avx512: return "avx512";
    }
    return "";
}

} // namespace reliefbake

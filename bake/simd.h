#pragma once
// Which instruction set the baking kernels use. Results are the same bits for every choice.

#include <vector>

namespace reliefbake {

enum class Simd { automatic, scalar, ssse3, sse4, avx2, avx512 };

/// Choices that this machine and this build can run, `automatic` first.
std::vector<Simd> available_simd();

/// For tests and benchmarks: restricts all later bakes of this process. `choice` must be available.
void use_simd(Simd choice);

const char* to_string(Simd choice);

} // namespace reliefbake

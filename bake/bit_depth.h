#pragma once
// How a channel is stored, and what its codes decode to.

namespace reliefbake {

enum class BitDepth { unorm8, unorm16, half, float32 };

inline bool is_unorm(BitDepth bits) { return bits == BitDepth::unorm8 || bits == BitDepth::unorm16; }

/// The largest integer code of a unorm format; 1 for floating formats, whose codes are the values themselves.
inline int max_code(BitDepth bits) {
    return bits == BitDepth::unorm8 ? 255 : bits == BitDepth::unorm16 ? 65535 : 1;
}

} // namespace reliefbake

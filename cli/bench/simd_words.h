#pragma once
// Words for the instruction sets of this machine.

#include "bake/simd.h"
#include "cli/choices.h"

namespace reliefbake {

/// Lives as long as the program: options keep a reference.
inline const Words<Simd>& simd_words() {
    static const Words<Simd> words = [] {
        Words<Simd> all;
        for (Simd choice : available_simd()) all.emplace_back(to_string(choice), choice);
        return all;
    }();
    return words;
}

} // namespace reliefbake

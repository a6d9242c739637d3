#pragma once
// The commands that a batch runs.

#include <string>

namespace reliefbake {

struct BakeKind {
    const char* word;      ///< the command's name
    const char* extension; ///< of its output, if a recipe does not say
    bool of_mesh;          ///< IN is a mesh
    /// Predictions (docs/BATCH.md has the measurements): nanoseconds a texel, or a byte of a mesh's file, with one thread.
    double nanoseconds;
};

/// Null for any other word.
const BakeKind* find_bake_kind(const std::string& word);

/// "cone, acm, ...".
std::string bake_kind_words();

} // namespace reliefbake

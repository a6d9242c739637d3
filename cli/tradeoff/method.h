#pragma once
// The ways to store and follow a relief that a sweep compares, by their words.

#include "cli/tradeoff/candidate.h"

#include <span>
#include <string_view>

namespace reliefbake {

/// A family of maps with the technique that follows it.
struct Method {
    std::string_view word;  ///< for --techniques
    std::string_view title; ///< in plots and tables
    bool by_default;        ///< part of a sweep that names none
    Candidate base;         ///< its steps and refinements are a sweep's to choose
};

std::span<const Method> all_methods();

/// Null for a word that is none.
const Method* find_method(std::string_view word);

} // namespace reliefbake

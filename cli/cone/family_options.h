#pragma once
// Options that choose a family of cones.

#include "bake/cone.h"
#include "bake/error.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <optional>
#include <string>

namespace reliefbake {

/// As given; what does not fit together is refused by `resolve_family`.
struct FamilyOptions {
    ConeFamily family = ConeFamily::conservative; ///< --kind
    std::optional<RelaxedRays> rays;              ///< --relaxed
    float slope = 0;                              ///< --relaxed slope:S
    std::optional<float> delta;                   ///< --delta
    ConeLookup lookup = ConeLookup::filtered;     ///< --lookup
};

/// `with_hybrid`: whether the command bakes hybrid cones.
void add_family_options(CLI::App& app, FamilyOptions& options, bool with_hybrid);

/// Refuses (usage) options that the family does not read; fills in the cone options.
Result<void> resolve_family(const FamilyOptions& given, ConeOptions& cone);

} // namespace reliefbake

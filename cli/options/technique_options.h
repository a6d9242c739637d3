#pragma once
// --technique, --exact-finish, --steps, --binary-steps: shared by `render` and `verify`.

#include "cli/command.h"
#include "shaders-reference/renderer/relief_renderer.h"

#include <optional>

namespace reliefbake {

struct TechniqueOptions {
    std::optional<Technique> technique; ///< unset: what suits the map
    bool exact_finish = false;
    std::optional<int> steps;        ///< of whichever kind the technique takes
    std::optional<int> binary_steps; ///< halvings or secants
};

/// `march_steps`: longest march of exact techniques where --steps is not given.
void add_technique_options(CLI::App& app, TechniqueOptions& options, int march_steps);

/// Steps and technique as the renderer takes them.
struct ResolvedTechnique {
    Technique technique;
    bool exact_finish;
    int max_steps, linear_steps, binary_steps;
};

void apply(const ResolvedTechnique& technique, RenderOptions& picture);

/// Refuses (usage) options that the technique does not use.
Result<ResolvedTechnique> resolve_technique(const TechniqueOptions& options, const ReliefMap& map, int march_steps);

} // namespace reliefbake

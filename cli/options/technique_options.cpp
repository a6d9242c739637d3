#include "cli/options/technique_options.h"

#include "cli/render/render_choices.h"

namespace reliefbake {

void add_technique_options(CLI::App& app, TechniqueOptions& options, int march_steps) {
    add_choice(app, "--technique", options.technique, technique_words,
               "How rays are followed (default: what suits the map, cone or relaxed)");
    app.add_flag("--exact-finish", options.exact_finish, "cone, cone-raw: solve the bilinear patch in the cell reached");
    app.add_option("--steps", options.steps,
                   "Longest march, or steps of the linear search (default " + std::to_string(march_steps) + "; relaxed 15; linear 64)")
        ->check(CLI::Range(1, 100000));
    app.add_option("--binary-steps", options.binary_steps,
                   "Halvings (relaxed, binary, dynamic) or secants (relaxed-secant, interval) at the end (default 8)")
        ->check(CLI::Range(0, 100));
}

Result<ResolvedTechnique> resolve_technique(const TechniqueOptions& options, const ReliefMap& map, int march_steps) {
    const TechniqueInfo& info = technique_info(options.technique.value_or(suitable_technique(map)));
    const std::string word(info.word);
    const bool finishes = info.technique == Technique::cone || info.technique == Technique::cone_raw;
    if (options.exact_finish && !finishes) return fail(ErrorCode::usage, "--exact-finish is for --technique cone or cone-raw, not " + word);
    if (options.steps && info.steps == TechniqueInfo::Steps::none)
        return fail(ErrorCode::usage, "--steps: technique " + word + " takes no steps");
    if (options.binary_steps && !info.refines)
        return fail(ErrorCode::usage, "--binary-steps: technique " + word + " does not refine");

    const RenderOptions defaults;
    const bool relaxed = info.steps == TechniqueInfo::Steps::march && info.refines;
    ResolvedTechnique resolved{info.technique, options.exact_finish, relaxed ? info.default_steps : march_steps,
                               defaults.linear_steps, options.binary_steps.value_or(defaults.binary_steps)};
    if (info.steps == TechniqueInfo::Steps::march) resolved.max_steps = options.steps.value_or(resolved.max_steps);
    if (info.steps == TechniqueInfo::Steps::linear) resolved.linear_steps = options.steps.value_or(info.default_steps);
    return resolved;
}

void apply(const ResolvedTechnique& technique, RenderOptions& picture) {
    picture.technique = technique.technique;
    picture.exact_finish = technique.exact_finish;
    picture.max_steps = technique.max_steps;
    picture.linear_steps = technique.linear_steps;
    picture.binary_steps = technique.binary_steps;
}

} // namespace reliefbake

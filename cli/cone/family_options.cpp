#include "cli/cone/family_options.h"

#include "cli/choices.h"
#include "cli/options/number_options.h"

namespace reliefbake {

namespace {

const Words<ConeFamily> families_with_hybrid = family_words;
const Words<ConeFamily> families_without_hybrid = {{"conservative", ConeFamily::conservative}, {"relaxed", ConeFamily::relaxed}};

void parse_relaxed(const std::string& given, FamilyOptions& options) {
    constexpr std::string_view prefix = "slope:";
    if (given == "strict") options.rays = RelaxedRays::strict;
    else if (given == "top") options.rays = RelaxedRays::top;
    else if (given.rfind(prefix, 0) == 0) {
        options.rays = RelaxedRays::slope;
        options.slope = float(require_number("--relaxed", given.substr(prefix.size()), positive_number));
    } else {
        throw CLI::ValidationError("--relaxed", "expected strict, top or slope:S, found '" + given + "'");
    }
}

} // namespace

void add_family_options(CLI::App& app, FamilyOptions& options, bool with_hybrid) {
    app.option_defaults()->group("Family");
    add_choice(app, "--kind", options.family, with_hybrid ? families_with_hybrid : families_without_hybrid,
               "What a ray may do inside a cone: meet nothing; pierce the relief once; or that and go at most --delta deep "
               "(default conservative)");
    app.add_option_function<std::string>(
           "--relaxed", [&options](const std::string& given) { parse_relaxed(given, options); },
           "Rays that relaxed cones must not let out again: all; those from the top on the axis, as GPU Gems 3 samples them; "
           "those that descend S of height per texture width or more (default strict)")
        ->type_name("strict|top|slope:S");
    if (with_hybrid)
        add_number(app, "--delta", options.delta, fraction_number, "Height that a step may go below the first surface it meets (hybrid)");
    add_choice(app, "--lookup", options.lookup, lookup_words,
               "How the shader fetches cones: filtered, or unfiltered for the cell (wider cones; default filtered)");
}

Result<void> resolve_family(const FamilyOptions& given, ConeOptions& cone) {
    if (given.rays && given.family == ConeFamily::conservative)
        return fail(ErrorCode::usage, "--relaxed: needs --kind relaxed or hybrid");
    if (given.rays && *given.rays != RelaxedRays::strict && given.family == ConeFamily::hybrid)
        return fail(ErrorCode::usage, "--relaxed: hybrid cones are strict ones, limited by --delta; leave --relaxed out");
    if (given.delta.has_value() != (given.family == ConeFamily::hybrid))
        return fail(ErrorCode::usage, given.delta ? "--delta: needs --kind hybrid" : "--kind hybrid: needs --delta, 0 to 1");
    if (given.lookup == ConeLookup::cell && cone.surface == SurfaceModel::texel)
        return fail(ErrorCode::usage, "--lookup cell: needs --surface bilinear; texel cones hold at texel centres alone");
    if (given.family != ConeFamily::conservative && cone.surface == SurfaceModel::texel)
        return fail(ErrorCode::usage, "--surface texel: is for conservative cones; a ray leaves the surface between texel centres");
    cone.family = given.family;
    cone.rays = given.rays.value_or(RelaxedRays::strict);
    cone.relaxed_slope = given.slope;
    cone.hybrid_delta = given.delta.value_or(0);
    cone.lookup = given.lookup;
    return {};
}

} // namespace reliefbake

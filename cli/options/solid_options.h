#pragma once
// What is made of a shape map and how its rays are followed: shared by `render` and `verify`.

#include "cli/command.h"
#include "shaders-reference/renderer/shape_renderer.h"

#include <optional>
#include <string>

namespace reliefbake {

/// As given; unset: by default.
struct SolidOptions {
    std::optional<SolidKind> kind;
    std::optional<bool> on_plane;
    std::optional<double> outward, bevel, chamfer, axis, depth_scale;
    std::optional<CircleScheme> scheme;
};

/// The option group of all that shape maps alone take.
constexpr const char* solid_group = "Solid (shape maps)";

/// Adds --e, --b, --c, --axis, --depth-scale, --scheme.
void add_solid_options(CLI::App& app, SolidOptions& options);

/// Adds --solid and --on too.
void add_solid_kind_options(CLI::App& app, SolidOptions& options);

/// Refuses (usage) the first option given whose group is `group` (empty: none), or whose flag is one of `flags`: "FLAG: `why`".
Result<void> refuse_given(const CLI::App& app, const std::string& group, std::initializer_list<const char*> flags, const std::string& why);

/// Refuses (usage) options that do not fit the kind.
Result<ShapeSolid> resolve_solid(const SolidOptions& options);

} // namespace reliefbake

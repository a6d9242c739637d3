#pragma once
// reliefbake render MAP -o PNG, where MAP is a shape map.

#include "cli/options/solid_options.h"

#include <optional>
#include <string>

namespace reliefbake {

/// Options that shape maps alone take.
struct RenderShapeOptions {
    SolidOptions solid;
    std::optional<Projection> projection;
    std::string texture;              ///< file; empty: none
    std::string bump;                 ///< file; empty: none
    std::optional<double> bump_scale;
    std::optional<std::pair<double, double>> texture_tiles;
};

void add_render_shape_options(CLI::App& app, RenderShapeOptions& options);

/// What the command line says beside them.
struct ShapePicture {
    std::string file;
    std::uint64_t max_bytes;
    std::string output;
    const RenderOptions& picture; ///< view, light, size
    std::optional<int> steps, binary_steps;
    RendererBackend backend;
};

Result<void> render_shape(const ShapePicture& given, const RenderShapeOptions& options);

} // namespace reliefbake

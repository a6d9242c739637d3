#pragma once
// --alpha and --alpha-threshold: where a relief has holes.

#include "bake/holes.h"
#include "formats/read_image.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <string>

namespace reliefbake {

struct AlphaOptions {
    std::string from;       ///< --alpha: a channel of the input, or another image of its size; empty: no holes
    float threshold = 0.5f; ///< --alpha-threshold: texels whose alpha is below it are holes
};

void add_alpha_options(CLI::App& app, AlphaOptions& options);

struct Alpha {
    HoleMask holes;
    std::string pixel_hash; ///< of the alpha plane
};

/// The holes of `source`, read from `input` or from a file of its own. A name that the input has among its channels is that
/// channel, any other one a file: of it the only channel counts, else its A, else its luminance.
/// Errors: no_input (neither a channel nor a file), bad_data (undecodable, another size, a NaN alpha).
Result<Alpha> read_alpha(const AlphaOptions& options, const std::string& input, const SourceImage& source, std::uint64_t max_bytes);

} // namespace reliefbake

#pragma once
// The command line of `reliefbake quadric`.

#include "bake/error.h"
#include "formats/mesh_file.h"
#include "mesh/quadric_bake.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <string>

namespace reliefbake {

struct QuadricCommandOptions {
    std::string input;      ///< MESH
    std::string output;     ///< -o, --output
    MeshReadOptions read;   ///< --max-bytes
    QuadricOptions quadric; ///< --fit --terms --frame --threads
    QuadricStore store;     ///< --store
    std::string preview;    ///< --preview: a PNG
    bool json = false, quiet = false;
};

void add_quadric_options(CLI::App& app, QuadricCommandOptions& options);

/// Resolves threads and refuses (usage, cannot_create) what cannot go together, before any work.
Result<QuadricCommandOptions> plan_quadric(const QuadricCommandOptions& options);

/// The words of the options, for messages and metadata.
std::string word_of_fit(QuadricFit fit);
std::string word_of_frame(FrameKind frame);
std::string word_of_store(const QuadricStore& store);

} // namespace reliefbake

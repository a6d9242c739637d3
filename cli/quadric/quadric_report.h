#pragma once
// What `reliefbake quadric` tells: metadata for the file, one object for scripts, a few lines for people, warnings.

#include "cli/quadric/quadric_options.h"
#include "cli/stage_clock.h"
#include "mesh/quadric_statistics.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace reliefbake {

/// Everything a finished bake knows about itself.
struct QuadricRun {
    const QuadricCommandOptions& plan;
    const MeshFile& file;
    std::span<const QuadricBake> bakes;
    QuadricCounts counts;
    QuadricStatistics statistics;
    std::vector<std::string> warnings;
};

/// What a program needs to use the numbers: formula, unit, frame, fit (docs/FORMATS.md).
nlohmann::json quadric_info(const QuadricCommandOptions& plan, std::span<const QuadricBake> bakes);

std::vector<std::string> quadric_warnings(const QuadricRun& run);

/// The object of --json: cli/schema/quadric.schema.json.
std::string quadric_result_text(const QuadricRun& run, const StageClock::Seconds& seconds);

/// A few lines for a person.
std::string quadric_summary(const QuadricRun& run, const StageClock::Seconds& seconds);

} // namespace reliefbake

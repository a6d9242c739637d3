#pragma once
// Which files become what: the options that batch, run and plan share.

#include "cli/batch/batch_plan.h"
#include "cli/command.h"

#include <string>
#include <vector>

namespace reliefbake {

struct BatchSources {
    std::vector<std::string> sources;
    std::string out, recipe, name = "{stem}_{kind}";

    /// SOURCES, --out, --recipe, --name.
    void add_to(CLI::App& app);

    /// Errors: those of the recipe, the sources and the plan.
    Result<BatchPlan> plan() const;

    /// These options as words of a command line.
    std::vector<std::string> words() const;
};

} // namespace reliefbake

#include "cli/bake_cone.h"

namespace reliefbake {

void ConeCommand::add_to(CLI::App& app) { add_cone_options(app, options_); }

Result<void> ConeCommand::run() {
    const Result<ConePlan> plan = plan_cone(options_);
    if (!plan) return tl::unexpected(plan.error());
    return {};
}

} // namespace reliefbake

#pragma once
// What a run of cases says: JSON, lines, and plots of where each encoding stops being useful.

#include "cli/stress/stress_case.h"
#include "cli/stress/usefulness.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace reliefbake {

nlohmann::json to_json(const StressResult& result);

/// Keys `encodings` and `useful` of cli/schema/stress.schema.json.
nlohmann::json usefulness_json(const std::vector<Usefulness>& measured);

std::string stress_heading();
/// A line for the cases of one field together.
std::string stress_line(const std::string& name, const std::vector<StressResult>& cases);

/// Up to which slope each encoding is useful.
std::string usefulness_text(const std::vector<Usefulness>& measured);

/// Width of cones kept, and dead texels, against slope.
std::string kept_svg(const std::vector<Usefulness>& measured);
std::string dead_svg(const std::vector<Usefulness>& measured);

} // namespace reliefbake

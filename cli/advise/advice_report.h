#pragma once
// What advise found, as JSON (cli/schema/advise.schema.json) and as lines.

#include "cli/advise/advice_search.h"

#include <nlohmann/json.hpp>

#include <string>

namespace reliefbake {

struct AdviceReport {
    std::string input;      ///< as given
    int width = 0, height = 0;
    double depth_scale = 0;
    ShaderTarget target = ShaderTarget::glsl;
    Budget budget;
    JudgeOptions judge;
    int crop = 0;           ///< side of the square that candidates were screened on; 0: the whole
    int screen_rays = 0;    ///< asked for of the screen; judge.rays of proofs
    AdvicePlan plan;
    Advice advice;          ///< of plan.ways
    std::string applied;    ///< file that was baked; empty: none
};

nlohmann::json advice_json(const AdviceReport& report);

/// The answer, what it costs and how it was measured, the runner-up, and of every other method why it fell; of no answer its
/// error alone (nearest_text).
std::string advice_text(const AdviceReport& report);

/// One line for the error where no candidate meets the budget: how many were measured, and the nearest miss.
std::string nearest_text(const AdviceReport& report);

const char* word_of_target(ShaderTarget target);

} // namespace reliefbake

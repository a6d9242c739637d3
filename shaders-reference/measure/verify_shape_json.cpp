#include "shaders-reference/measure/verify_shape.h"

#include <cmath>

namespace reliefbake {

nlohmann::json to_json(const ShapeVerifyReport& report) {
    nlohmann::json json = {{"verdict", to_string(report.verdict)},
                           {"points", report.distances.points},
                           {"violations", report.distances.violations},
                           {"worst", {{"excess_texels", report.distances.worst}, {"u", report.distances.u}, {"v", report.distances.v}}},
                           {"allowed_gap", report.allowed_gap},
                           {"oracle_rays_per_second", report.oracle_rays_per_second},
                           {"solids", nlohmann::json::array()}};
    for (const SolidReport& entry : report.solids) {
        const SolidComparison& rays = entry.comparison;
        const double c = entry.solid.chamfer;
        json["solids"].push_back({{"name", entry.name},
                                  {"e", entry.solid.outward},
                                  {"b", entry.solid.bevel},
                                  {"c", std::isfinite(c) ? nlohmann::json(c) : nlohmann::json()},
                                  {"rays", rays.rays},
                                  {"hits", rays.hits},
                                  {"missed", rays.missed},
                                  {"early", rays.early},
                                  {"out_of_steps", rays.out_of_steps},
                                  {"not_finite", rays.not_finite},
                                  {"gap_mean", rays.gap_mean},
                                  {"gap_max", rays.gap_max},
                                  {"normal_mean", rays.normal_mean},
                                  {"normal_95", rays.normal_95},
                                  {"steps_mean", rays.steps_mean},
                                  {"steps_max", rays.steps_max},
                                  {"fetches_mean", rays.fetches_mean},
                                  {"milliseconds", entry.milliseconds}});
    }
    return json;
}

} // namespace reliefbake

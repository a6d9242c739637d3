#include "shaders-reference/measure/verify.h"

namespace reliefbake {
namespace {

double share(std::uint64_t part, std::uint64_t whole) { return whole > 0 ? double(part) / double(whole) : 0; }

nlohmann::json rays_json(const Comparison& rays) {
    return {{"rays", rays.rays},
            {"holes", share(rays.holes, rays.rays)},
            {"pierced", share(rays.pierced, rays.rays)},
            {"filled", share(rays.filled, rays.rays)},
            {"missed", share(rays.missed, rays.rays)},
            {"skipped", share(rays.skipped, rays.rays)},
            {"early", share(rays.early, rays.rays)},
            {"out_of_steps", share(rays.out_of_steps, rays.rays)},
            {"mse", rays.mse},
            {"steps_mean", rays.steps_mean},
            {"steps_max", rays.steps_max},
            {"fetches_mean", rays.fetches_mean}};
}

} // namespace

std::string to_string(Verdict verdict) {
    switch (verdict) {
    case Verdict::safe: return "safe";
    case Verdict::unsafe: return "unsafe";
    case Verdict::other_source: return "other_source";
    case Verdict::not_conservative: return "not_conservative";
    }
    return {};
}

nlohmann::json to_json(const VerifyReport& report) {
    nlohmann::json json = rays_json(report.total);
    json["verdict"] = to_string(report.verdict);
    json["points"] = report.cones.points;
    json["violations"] = report.cones.violations;
    json["worst"] = {{"excess", report.cones.worst},
                     {"u", report.cones.u},
                     {"v", report.cones.v},
                     {"heading", report.cones.heading}};
    json["tightness"] = report.tightness ? nlohmann::json(*report.tightness) : nlohmann::json();
    json["tolerance"] = report.tolerance;
    json["oracle_rays_per_second"] = report.oracle_rays_per_second;
    if (report.depth_difference) json["depth_difference"] = *report.depth_difference;
    json["views"] = nlohmann::json::array();
    for (const ViewReport& view : report.views) {
        nlohmann::json entry = rays_json(view.comparison);
        entry["angle"] = view.angle;
        entry["azimuth"] = view.azimuth;
        entry["milliseconds"] = view.milliseconds;
        json["views"].push_back(entry);
    }
    return json;
}

} // namespace reliefbake

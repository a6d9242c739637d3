#include "cli/verify/verify_text.h"

#include "cli/report/format_text.h"

#include <cmath>

namespace reliefbake {

namespace {

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? 100 * double(part) / double(whole) : 0;
}

std::string rays_line(const char* label, const Comparison& rays) {
    return format("%-12s %8llu %9.4f %10.4f %9.4f %10.2e %7.1f %6.0f %8.1f\n", label,
                static_cast<unsigned long long>(rays.rays), percent(rays.missed, rays.rays), percent(rays.skipped, rays.rays),
                percent(rays.early, rays.rays), rays.mse, rays.steps_mean, rays.steps_max, rays.fetches_mean);
}

} // namespace

std::string verify_text(const VerifyReport& report) {
    std::string text = "view              rays  missed %  skipped %   early %        mse   steps    max  fetches\n";
    for (const ViewReport& view : report.views)
        text += rays_line(format("%2.0f deg @ %3.0f", view.angle, view.azimuth).c_str(), view.comparison);
    text += rays_line("all", report.total);
    if (report.has_holes)
        text += format("holes: %llu rays fell through; %llu of them where there is relief; %llu others stopped where there is none\n",
                     static_cast<unsigned long long>(report.total.holes), static_cast<unsigned long long>(report.total.pierced),
                     static_cast<unsigned long long>(report.total.filled));
    if (report.cones.points == 0) text += "cones: not checked at points\n";
    else
        text += format("cones: %llu of %llu points violated; worst cone reaches %.6f of its limit at u %.6f, v %.6f\n",
                     static_cast<unsigned long long>(report.cones.violations),
                     static_cast<unsigned long long>(report.cones.points), report.cones.worst, report.cones.u,
                     report.cones.v);
    if (report.tightness)
        text += format("tightness: %.4f of the best one value per texel can do\n", *report.tightness);
    if (report.depth_difference)
        text += format("depth: at most %.3e from the source\n", *report.depth_difference);
    return text + "verdict: " + to_string(report.verdict) + "\n";
}

std::string verify_text(const ShapeVerifyReport& report) {
    std::string text = "solid                            rays     hits  missed   early  no end  gap, mean  normal: mean    95 %   steps    max\n";
    const auto count = [](std::uint64_t number) { return static_cast<unsigned long long>(number); };
    for (const SolidReport& solid : report.solids) {
        const SolidComparison& rays = solid.comparison;
        text += format("%-28s %8llu %8llu %7llu %7llu %7llu %10.2e %9.2f deg %5.1f deg %7.1f %6.0f\n", solid.name.c_str(), count(rays.rays), count(rays.hits),
                     count(rays.missed), count(rays.early), count(rays.out_of_steps), rays.gap_mean, rays.normal_mean, rays.normal_95, rays.steps_mean, rays.steps_max);
        if (rays.not_finite > 0) text += format("  %llu samples are not finite\n", count(rays.not_finite));
    }
    text += format("a hit is early when it lies more than %.3e texture widths before the solid\n", report.allowed_gap);
    text += format("distances: %llu of %llu points violated; the worst leaves %.4f texels at u %.6f, v %.6f\n", count(report.distances.violations),
                 count(report.distances.points), std::abs(report.distances.worst) < 5e-5 ? 0 : -report.distances.worst, report.distances.u, report.distances.v);
    return text + "verdict: " + to_string(report.verdict) + "\n";
}

std::string verify_text(const MeshVerifyReport& report) {
    std::string text = "view               truth  IoU      band     cut IoU  holes    wrong   depth: mean    99 %     max   steps\n";
    const auto count = [](std::uint64_t number) { return static_cast<unsigned long long>(number); };
    const auto line = [&](const std::string& label, const MeshComparison& c) {
        text += format("%-12s %10llu  %.4f  %.4f  %.4f %8llu %8llu %10.4f %9.4f %7.3f %7.1f\n", label.c_str(), count(c.truth), c.iou(), c.band_agreement(), c.cut_iou(),
                       count(c.holes), count(c.wrong_cover), c.depth_mean, c.depth_99, c.depth_max, c.steps_mean);
        if (c.not_finite > 0) text += format("  %llu pixels are not finite\n", count(c.not_finite));
    };
    for (const MeshViewReport& view : report.views) line(format("%2.0f deg @ %3.0f", view.view.angle, view.view.azimuth), view.comparison);
    line("all", report.total);
    return text + format("depths in units of the depth scale, %g of the mesh's; pixels in the band: %llu\n", report.depth_scale, count(report.total.band));
}

} // namespace reliefbake

#pragma once
// A plot with two logarithmic axes as an SVG text.

#include <string>
#include <utility>
#include <vector>

namespace reliefbake {

struct PlotSeries {
    std::string title; ///< in the legend
    std::vector<std::pair<double, double>> points; ///< x, y; joined by a line in their order
};

struct LogPlot {
    std::string title, x_label, y_label;
    std::vector<PlotSeries> series; ///< up to 16 look different
    std::vector<std::pair<double, double>> dots;  ///< small and grey: what the curves do not hold
    std::vector<std::pair<double, double>> front; ///< drawn as a step behind all
    double least_y = 1e-6; ///< smaller values are drawn here, on the axis
};

/// Self-contained, with the legend beside the plot. Points with x <= 0 are left out.
std::string svg_text(const LogPlot& plot);

/// Text for XML or HTML: & < > " replaced.
std::string escaped(const std::string& text);

} // namespace reliefbake

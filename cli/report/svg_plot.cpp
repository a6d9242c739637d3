#include "cli/report/svg_plot.h"

#include "cli/report/format_text.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double width = 760, height = 430, left = 72, right = 560, top = 34, bottom = 380;
constexpr const char* colours[] = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17a2b8", "#8c564b", "#e377c2"};
constexpr std::size_t colour_count = std::size(colours);

/// One logarithmic axis: values from low to high lie between two pixels.
struct LogAxis {
    double low, high, pixel_low, pixel_high;

    double at(double value) const {
        const double share = std::log(std::clamp(value, low, high) / low) / std::log(high / low);
        return pixel_low + share * (pixel_high - pixel_low);
    }
    /// Whole decades, and where they are few 2 and 5 between them.
    std::vector<double> ticks() const {
        const bool few = std::log10(high / low) < 2.5;
        std::vector<double> values;
        for (int decade = int(std::floor(std::log10(low))); decade <= int(std::ceil(std::log10(high))); ++decade)
            for (const int digit : {1, 2, 5}) {
                const double value = digit * std::pow(10, decade);
                if ((digit == 1 || few) && value > low * 0.999 && value < high * 1.001) values.push_back(value);
            }
        return values;
    }
};

std::string tick_text(double value) {
    if (value >= 0.001 && value < 100000) return format("%.6g", value);
    return format("%.0e", value);
}

std::string marker(std::size_t series, double x, double y) {
    const char* colour = colours[series % colour_count];
    if (series < colour_count) return format("<circle cx='%.1f' cy='%.1f' r='3' fill='%s'/>", x, y, colour);
    return format("<rect x='%.1f' y='%.1f' width='6.4' height='6.4' fill='white' stroke-width='1.6' stroke='%s'/>", x - 3.2, y - 3.2, colour);
}

std::string dash(std::size_t series) { return series < colour_count ? "" : " stroke-dasharray='6 3'"; }

std::string axes_text(const LogPlot& plot, const LogAxis& x, const LogAxis& y) {
    std::string text;
    for (const double value : x.ticks()) {
        text += format("<path d='M%.1f %.0fV%.0f' stroke='#ddd'/>", x.at(value), top, bottom);
        text += format("<text x='%.1f' y='%.0f' text-anchor='middle'>%s</text>\n", x.at(value), bottom + 16, tick_text(value).c_str());
    }
    for (const double value : y.ticks()) {
        text += format("<path d='M%.0f %.1fH%.0f' stroke='#ddd'/>", left, y.at(value), right);
        text += format("<text x='%.0f' y='%.1f' text-anchor='end'>%s</text>\n", left - 6, y.at(value) + 4, tick_text(value).c_str());
    }
    text += format("<rect x='%.0f' y='%.0f' width='%.0f' height='%.0f' fill='none' stroke='#444'/>\n", left, top, right - left, bottom - top);
    text += format("<text x='%.0f' y='20' font-size='14' font-weight='bold'>", left) + escaped(plot.title) + "</text>\n";
    text += format("<text x='%.0f' y='%.0f' text-anchor='middle'>", (left + right) / 2, height - 12) + escaped(plot.x_label) + "</text>\n";
    return text + format("<text transform='translate(16 %.0f) rotate(-90)' text-anchor='middle'>", (top + bottom) / 2) + escaped(plot.y_label) + "</text>\n";
}

/// Smallest and largest x, and y not below `least_y`, of all that is drawn, a little widened.
std::pair<LogAxis, LogAxis> make_axes(const LogPlot& plot) {
    double x_low = INFINITY, x_high = 0, y_low = INFINITY, y_high = 0;
    const auto take = [&](const std::vector<std::pair<double, double>>& points) {
        for (const auto& [x, y] : points) {
            if (!(x > 0)) continue;
            x_low = std::min(x_low, x), x_high = std::max(x_high, x);
            y_low = std::min(y_low, std::max(y, plot.least_y)), y_high = std::max(y_high, std::max(y, plot.least_y));
        }
    };
    for (const PlotSeries& series : plot.series) take(series.points);
    take(plot.dots);
    if (x_high == 0) x_low = x_high = y_low = y_high = 1;
    return {{x_low / 1.15, x_high * 1.15, left, right}, {y_low / 1.3, y_high * 1.3, bottom, top}};
}

} // namespace

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&') safe += "&amp;";
        else if (c == '<') safe += "&lt;";
        else if (c == '>') safe += "&gt;";
        else if (c == '"') safe += "&quot;";
        else safe += c;
    }
    return safe;
}

std::string svg_text(const LogPlot& plot) {
    const auto [x, y] = make_axes(plot);
    std::string text = format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %.0f %.0f' width='%.0f' height='%.0f' font-family='sans-serif' font-size='12'>\n"
                              "<rect width='100%%' height='100%%' fill='white'/>\n", width, height, width, height);
    text += axes_text(plot, x, y);

    // Behind all, the front; then what is off the curves; then the curves.
    if (!plot.front.empty()) {
        text += "<path fill='none' stroke='#000' stroke-opacity='0.18' stroke-width='7' stroke-linejoin='round' d='";
        for (std::size_t k = 0; k < plot.front.size(); ++k)
            text += k == 0 ? format("M%.1f %.1f", x.at(plot.front[k].first), y.at(plot.front[k].second))
                           : format("H%.1fV%.1f", x.at(plot.front[k].first), y.at(plot.front[k].second));
        text += "'/>\n";
    }
    for (const auto& [u, v] : plot.dots)
        if (u > 0) text += format("<circle cx='%.1f' cy='%.1f' r='1.6' fill='#999'/>", x.at(u), y.at(v));
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        std::string path, marks;
        for (const auto& [u, v] : plot.series[s].points) {
            if (!(u > 0)) continue;
            path += format("%s%.1f %.1f", path.empty() ? "M" : "L", x.at(u), y.at(v));
            marks += marker(s, x.at(u), y.at(v));
        }
        text += "<path fill='none' stroke-width='1.5' stroke='" + std::string(colours[s % colour_count]) + "'" + dash(s) + " d='" + path + "'/>" + marks + "\n";
        const double row = top + 8 + 21 * double(s);
        text += format("<path d='M%.0f %.0fh26' stroke-width='1.5' stroke='%s'%s/>", right + 16, row, colours[s % colour_count], dash(s).c_str());
        text += marker(s, right + 29, row) + format("<text x='%.0f' y='%.0f'>", right + 50, row + 4) + escaped(plot.series[s].title) + "</text>\n";
    }
    const double row = top + 8 + 21 * double(plot.series.size());
    if (!plot.front.empty())
        text += format("<path d='M%.0f %.0fh26' stroke='#000' stroke-opacity='0.18' stroke-width='7'/><text x='%.0f' y='%.0f'>Pareto front</text>\n", right + 16, row, right + 50, row + 4);
    if (!plot.dots.empty())
        text += format("<circle cx='%.0f' cy='%.0f' r='1.6' fill='#999'/><text x='%.0f' y='%.0f'>one axis varied</text>\n", right + 29, row + 21, right + 50, row + 25);
    return text + "</svg>\n";
}

} // namespace reliefbake

// SPDX-License-Identifier: BSD-3-Clause
#include "measurement/dot_plot.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
const char* const kColours[] = {"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e",
                                "#9467bd", "#8c564b", "#17becf", "#7f7f7f"};
constexpr double kTop = 90.0;  // px, all below too
constexpr double kRow = 64.0;
constexpr double kLeft = 130.0;
constexpr double kPanel = 380.0;
constexpr double kGap = 40.0;

// A logarithmic axis of one panel.
struct Axis
{
    double left;
    double low;
    double high;
    const char* title;
    std::vector<double> ticks;

    double at(double value) const
    {
        const double inside = std::clamp(value, low, high);
        return left + kPanel * std::log(inside / low) / std::log(high / low);
    }
};

std::vector<std::string> distinct(const std::vector<CaseSummary>& rows,
                                  std::string CaseSummary::*member)
{
    std::vector<std::string> names;
    for (const CaseSummary& row : rows)
        if (std::find(names.begin(), names.end(), row.*member) == names.end())
            names.push_back(row.*member);
    return names;
}

double indexIn(const std::vector<std::string>& names, const std::string& name)
{
    return static_cast<double>(
        std::distance(names.begin(), std::find(names.begin(), names.end(), name)));
}

std::string px(double value)
{
    return "\"" + toFixedText(value, 1) + "\"";
}

std::string text(double x, double y, const std::string& anchor, const std::string& words)
{
    return "<text x=" + px(x) + " y=" + px(y) + " text-anchor=\"" + anchor + "\">" + words +
           "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& colour)
{
    return "<line x1=" + px(x1) + " y1=" + px(y1) + " x2=" + px(x2) + " y2=" + px(y2) +
           " stroke=\"" + colour + "\"/>\n";
}

std::string axisOf(const Axis& axis, double bottom)
{
    std::string svg = text(axis.left + 0.5 * kPanel, kTop - 24.0, "middle", axis.title);
    for (const double tick : axis.ticks)
    {
        svg += line(axis.at(tick), kTop, axis.at(tick), bottom, "#ddd");
        svg += text(axis.at(tick), kTop - 6.0, "middle", toText(tick));
    }
    return svg;
}

std::string dot(const Axis& axis, double y, const ErrorFigures& figures, const char* colour)
{
    if (!std::isfinite(figures.median)) return "";
    return line(axis.at(figures.median), y, axis.at(figures.p90), y, colour) +
           "<circle cx=" + px(axis.at(figures.median)) + " cy=" + px(y) + " r=\"3.5\" fill=\"" +
           colour + "\"/>\n";
}
}  // namespace

std::string dotPlot(const std::vector<CaseSummary>& rows)
{
    const std::vector<std::string> conditions = distinct(rows, &CaseSummary::condition);
    std::vector<std::string> methods = distinct(rows, &CaseSummary::method);
    methods.resize(std::min(methods.size(), std::size(kColours)));
    const Axis heading{kLeft, 0.1, 45.0, "heading error, deg", {0.1, 0.3, 1.0, 3.0, 10.0, 45.0}};
    const Axis corner{kLeft + kPanel + kGap,
                      0.02,
                      3.0,
                      "nearest corner error, m",
                      {0.02, 0.05, 0.1, 0.3, 1.0, 3.0}};
    const double bottom = kTop + kRow * static_cast<double>(conditions.size());
    const double width = kLeft + 2.0 * (kPanel + kGap);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=" + px(width) +
                      " height=" + px(bottom + 20.0) +
                      " font-family=\"sans-serif\" font-size=\"12\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    svg += axisOf(heading, bottom) + axisOf(corner, bottom);
    for (std::size_t k = 0; k < methods.size(); ++k)
    {
        const double x = 12.0 + static_cast<double>(k % 4) * (width - 12.0) / 4.0;
        const double y = k < 4 ? 16.0 : 34.0;
        svg += "<circle cx=" + px(x) + " cy=" + px(y) + " r=\"4\" fill=\"" + kColours[k] + "\"/>\n";
        svg += text(x + 8.0, y + 4.0, "start", methods[k]);
    }
    for (std::size_t k = 0; k < conditions.size(); ++k)
    {
        const double top = kTop + kRow * static_cast<double>(k);
        svg += line(12.0, top, width - kGap, top, "#bbb");
        svg += text(kLeft - 12.0, top + 0.5 * kRow + 4.0, "end", conditions[k]);
    }
    for (const CaseSummary& row : rows)
    {
        const double method = indexIn(methods, row.method);
        if (method >= static_cast<double>(methods.size())) continue;
        const double y = kTop + kRow * indexIn(conditions, row.condition) +
                         kRow * (method + 1.0) / (static_cast<double>(methods.size()) + 1.0);
        const char* colour = kColours[static_cast<std::size_t>(method)];
        svg += dot(heading, y, row.heading90, colour) + dot(corner, y, row.corner, colour);
    }
    return svg + "</svg>\n";
}

}  // namespace vdamf

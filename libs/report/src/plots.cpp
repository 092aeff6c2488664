// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/plots.h"

#include <algorithm>
#include <cmath>

#include "axis_marks.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
// Pixels of one chart and of what surrounds its field.
constexpr double kWidth = 480.0;
constexpr double kHeight = 340.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 16.0;
constexpr double kTop = 34.0;
constexpr double kBottom = 52.0;
constexpr double kLegendLine = 17.0;

// Told apart also by the colour-blind (Okabe and Ito).
const char* const kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#e69f00", "#56b4e9", "#000000"};

std::string px(double value)
{
    return toFixedText(value, 1);
}

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += c;
    }
    return result;
}

std::string textSvg(double x, double y, const std::string& text, const std::string& attributes)
{
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" " + attributes + ">" + escaped(text) +
           "</text>\n";
}

std::string lineSvg(double x1, double y1, double x2, double y2, const std::string& attributes)
{
    return "<path d=\"M" + px(x1) + " " + px(y1) + "L" + px(x2) + " " + px(y2) + "\" " +
           attributes + "/>\n";
}

std::string strokeOf(CurveStyle style)
{
    const std::string common = "fill=\"none\" stroke-width=";
    if (style == CurveStyle::Points) return common + "\"5\" stroke-linecap=\"round\"";
    if (style == CurveStyle::Dashed) return common + "\"1\" stroke-dasharray=\"5 4\"";
    return common + "\"2\"";
}

bool isInLegend(const Curve& curve)
{
    return !curve.name.empty() && !curve.points.empty();
}

std::vector<double> valuesOf(const Chart& chart, Eigen::Index coordinate)
{
    std::vector<double> values;
    for (const Curve& curve : chart.curves)
    {
        for (const Eigen::Vector2d& point : curve.points) values.push_back(point[coordinate]);
    }
    return values;
}

/// One chart with its upper left corner at (0, 0).
class ChartDrawing
{
public:
    explicit ChartDrawing(const Chart& chart)
        : chart_(chart), x_(chart.x, valuesOf(chart, 0)), y_(chart.y, valuesOf(chart, 1))
    {
    }

    std::string svg() const
    {
        std::string svg = textSvg(0.5 * kWidth, 20.0, chart_.title,
                                  "text-anchor=\"middle\" font-weight=\"bold\"");
        svg += gridSvg();
        const auto isEmpty = [](const Curve& curve) { return curve.points.empty(); };
        if (std::all_of(chart_.curves.begin(), chart_.curves.end(), isEmpty))
        {
            return svg + textSvg(xAt(0.5), yAt(0.5), "nothing to show", "text-anchor=\"middle\"");
        }
        svg += "<g clip-path=\"url(#field)\">\n";
        for (std::size_t i = 0; i < chart_.curves.size(); ++i)
            svg += curveSvg(chart_.curves[i], colourOf(i));
        return svg + "</g>\n" + legendSvg();
    }

    static double xAt(double place) { return kLeft + place * (kWidth - kLeft - kRight); }
    static double yAt(double place)
    {
        return kHeight - kBottom - place * (kHeight - kTop - kBottom);
    }

private:
    std::string colourOf(std::size_t curve) const
    {
        return kColours[chart_.curves[curve].colour.value_or(curve) % std::size(kColours)];
    }

    std::string gridSvg() const
    {
        std::string svg;
        for (const AxisMark& mark : x_.marks())
        {
            svg += lineSvg(xAt(mark.place), yAt(0), xAt(mark.place), yAt(1), "stroke=\"#dddddd\"");
            svg += textSvg(xAt(mark.place), yAt(0) + 16.0, mark.text, "text-anchor=\"middle\"");
        }
        for (const AxisMark& mark : y_.marks())
        {
            svg += lineSvg(xAt(0), yAt(mark.place), xAt(1), yAt(mark.place), "stroke=\"#dddddd\"");
            svg += textSvg(xAt(0) - 6.0, yAt(mark.place) + 4.0, mark.text, "text-anchor=\"end\"");
        }
        svg += "<rect fill=\"none\" stroke=\"#555555\" x=\"" + px(xAt(0)) + "\" y=\"" + px(yAt(1)) +
               "\" width=\"" + px(xAt(1) - xAt(0)) + "\" height=\"" + px(yAt(0) - yAt(1)) +
               "\"/>\n";
        svg += textSvg(xAt(0.5), kHeight - 14.0, chart_.x.label, "text-anchor=\"middle\"");
        const std::string turned =
            "text-anchor=\"middle\" transform=\"rotate(-90 14 " + px(yAt(0.5)) + ")\"";
        return svg + textSvg(14.0, yAt(0.5), chart_.y.label, turned);
    }

    std::string curveSvg(const Curve& curve, const std::string& colour) const
    {
        std::string path;
        std::string dots;
        bool penDown = false;
        Eigen::Vector2d last(0.0, 0.0);
        for (std::size_t i = 0; i < curve.points.size(); ++i)
        {
            const auto x = x_.place(curve.points[i].x());
            const auto y = y_.place(curve.points[i].y());
            const bool shown = x && y && std::abs(*x) < 1e3 && std::abs(*y) < 1e3;
            if (!shown)
            {
                penDown = false;
                continue;
            }
            const Eigen::Vector2d at(xAt(*x), yAt(*y));
            // What nobody can see makes pictures of long runs large.
            const bool isEnd = i + 1 == curve.points.size();
            if (penDown && !isEnd && (at - last).norm() < 0.4) continue;
            path += (penDown ? "L" : "M") + px(at.x()) + " " + px(at.y());
            dots += "M" + px(at.x()) + " " + px(at.y()) + "h0";
            penDown = true;
            last = at;
        }
        return "<path d=\"" + (curve.style == CurveStyle::Points ? dots : path) + "\" " +
               strokeOf(curve.style) + " stroke=\"" + colour + "\"/>\n";
    }

    std::string legendSvg() const
    {
        std::size_t named = 0;
        std::size_t longest = 0;
        for (const Curve& curve : chart_.curves)
        {
            if (!isInLegend(curve)) continue;
            ++named;
            longest = std::max(longest, curve.name.size());
        }
        if (named == 0) return "";
        const double width = 40.0 + 6.6 * static_cast<double>(longest);
        const double height = kLegendLine * static_cast<double>(named) + 8.0;
        const double left = xAt(1) - width - 6.0;
        const double top = chart_.legendAtBottom ? yAt(0) - height - 6.0 : yAt(1) + 6.0;
        std::string svg = "<rect fill=\"#ffffff\" fill-opacity=\"0.85\" stroke=\"#cccccc\" x=\"" +
                          px(left) + "\" y=\"" + px(top) + "\" width=\"" + px(width) +
                          "\" height=\"" + px(height) + "\"/>\n";
        double y = top + 16.0;
        for (std::size_t i = 0; i < chart_.curves.size(); ++i)
        {
            const Curve& curve = chart_.curves[i];
            if (!isInLegend(curve)) continue;
            svg += lineSvg(left + 6.0, y - 4.0, left + 26.0, y - 4.0,
                           strokeOf(curve.style) + " stroke=\"" + colourOf(i) + "\"");
            svg += textSvg(left + 32.0, y, curve.name, "");
            y += kLegendLine;
        }
        return svg;
    }

    const Chart& chart_;
    ScaledAxis x_;
    ScaledAxis y_;
};
}  // namespace

std::string chartsSvg(const std::vector<Chart>& charts, std::size_t columns)
{
    const std::size_t across = std::max<std::size_t>(1, std::min(columns, charts.size()));
    const std::size_t rows = (charts.size() + across - 1) / across;
    const std::string width = toFixedText(kWidth * static_cast<double>(across), 0);
    const std::string height = toFixedText(kHeight * static_cast<double>(rows), 0);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
                      "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
                      "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    svg += "<clipPath id=\"field\"><rect x=\"" + px(ChartDrawing::xAt(0)) + "\" y=\"" +
           px(ChartDrawing::yAt(1)) + "\" width=\"" +
           px(ChartDrawing::xAt(1) - ChartDrawing::xAt(0)) + "\" height=\"" +
           px(ChartDrawing::yAt(0) - ChartDrawing::yAt(1)) + "\"/></clipPath>\n";
    for (std::size_t i = 0; i < charts.size(); ++i)
    {
        svg += "<g transform=\"translate(" + px(kWidth * static_cast<double>(i % across)) + " " +
               px(kHeight * static_cast<double>(i / across)) + ")\">\n" +
               ChartDrawing(charts[i]).svg() + "</g>\n";
    }
    return svg + "</svg>\n";
}

Curve cumulativeCurve(const std::string& name, std::vector<double> values)
{
    for (double& value : values) value = std::abs(value);
    std::sort(values.begin(), values.end());
    Curve curve;
    curve.name = name;
    if (!values.empty()) curve.points.emplace_back(0.0, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const double share = static_cast<double>(i + 1) / static_cast<double>(values.size());
        curve.points.emplace_back(values[i], share);
    }
    return curve;
}

}  // namespace vdamf

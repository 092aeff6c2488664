// SPDX-License-Identifier: BSD-3-Clause
#include "pareto_chart.h"

#include <algorithm>
#include <cmath>

#include "html.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr double kWidth = 640.0;
constexpr double kHeight = 380.0;
constexpr double kPlotLeft = 64.0;
constexpr double kPlotRight = 24.0;
constexpr double kPlotTop = 20.0;
constexpr double kPlotBottom = 48.0;
constexpr int kMarks = 5;

/// From numbers to pixels, with a margin around the numbers and marks at round ones.
struct Scale
{
    double min = 0.0;
    double max = 1.0;
    double begin = 0.0;
    double end = 1.0;

    Scale(const std::vector<double>& values, double beginPixel, double endPixel)
        : begin(beginPixel), end(endPixel)
    {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        const double spread = *most - *least;
        const double margin = spread > 0.0 ? 0.08 * spread : std::max(1e-6, 0.1 * std::abs(*most));
        min = *least - margin;
        max = *most + margin;
    }

    double at(double value) const { return begin + (end - begin) * (value - min) / (max - min); }

    std::vector<double> marks() const
    {
        const double raw = (max - min) / kMarks;
        const double decade = std::pow(10.0, std::floor(std::log10(raw)));
        double step = 10.0 * decade;
        for (const double factor : {5.0, 2.0, 1.0})
            if (factor * decade >= raw) step = factor * decade;
        std::vector<double> all;
        for (double i = std::ceil(min / step); i * step <= max; i += 1.0) all.push_back(i * step);
        return all;
    }
};

std::string px(double value)
{
    return toFixedText(value, 1);
}

std::string textSvg(double x, double y, const std::string& text, const std::string& attributes)
{
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" " + attributes + ">" + escapedHtml(text) +
           "</text>\n";
}

std::string gridSvg(const Scale& x, const Scale& y, const SweepResults& results)
{
    std::string svg;
    for (const double mark : x.marks())
    {
        svg += "<path class=\"grid\" d=\"M" + px(x.at(mark)) + " " + px(y.begin) + "V" + px(y.end) +
               "\"/>\n";
        svg += textSvg(x.at(mark), y.begin + 18.0, shownNumber(mark), "text-anchor=\"middle\"");
    }
    for (const double mark : y.marks())
    {
        svg += "<path class=\"grid\" d=\"M" + px(x.begin) + " " + px(y.at(mark)) + "H" + px(x.end) +
               "\"/>\n";
        svg += textSvg(x.begin - 7.0, y.at(mark) + 4.0, shownNumber(mark), "text-anchor=\"end\"");
    }
    svg += textSvg(0.5 * (x.begin + x.end), kHeight - 10.0, "tracking, ms per frame",
                   "text-anchor=\"middle\"");
    const std::string middle = px(0.5 * (y.begin + y.end));
    return svg + textSvg(14.0, 0.5 * (y.begin + y.end),
                         results.goal.metric +
                             (results.goal.highest ? " (higher is better)" : " (lower is better)"),
                         "text-anchor=\"middle\" transform=\"rotate(-90 14 " + middle + ")\"");
}

std::string tooltip(const SweepResults& results, const SettingSummary& summary, std::size_t setting)
{
    std::string text = "setting " + std::to_string(setting + 1);
    for (std::size_t k = 0; k < results.keys.size(); ++k)
        text += "\n" + results.keys[k] + " = " + results.settings[setting].values[k];
    return text + "\n" + results.goal.metric + " " +
           shownNumber(summary.means[goalIndex(results)]) + "\n" + shownNumber(summary.msPerFrame) +
           " ms per frame";
}

class ParetoDrawing
{
public:
    ParetoDrawing(const SweepResults& results, const std::vector<SettingSummary>& all,
                  const std::vector<double>& times, const std::vector<double>& scores)
        : results_(results),
          all_(all),
          front_(paretoFront(results)),
          x_(times, kPlotLeft, kWidth - kPlotRight),
          y_(scores, kHeight - kPlotBottom, kPlotTop)
    {
    }

    std::string svg() const
    {
        std::string svg = gridSvg(x_, y_, results_) + frontSvg();
        for (std::size_t s = 0; s < all_.size(); ++s)
            if (all_[s].means[goalIndex(results_)] && all_[s].msPerFrame) svg += pointSvg(s);
        return svg;
    }

private:
    double x(std::size_t s) const { return x_.at(*all_[s].msPerFrame); }
    double y(std::size_t s) const { return y_.at(*all_[s].means[goalIndex(results_)]); }

    // A step: between two settings the earlier one is what is to be had.
    std::string frontSvg() const
    {
        std::string path = "M" + px(x(front_.front())) + " " + px(y(front_.front()));
        for (std::size_t i = 1; i < front_.size(); ++i)
            path += "H" + px(x(front_[i])) + "V" + px(y(front_[i]));
        return "<path class=\"front\" d=\"" + path + "\"/>\n";
    }

    std::string pointSvg(std::size_t s) const
    {
        const bool isFront = std::find(front_.begin(), front_.end(), s) != front_.end();
        std::string svg = "<circle class=\"" + std::string(isFront ? "point best" : "point") +
                          "\" data-setting=\"" + std::to_string(s + 1) + "\" cx=\"" + px(x(s)) +
                          "\" cy=\"" + px(y(s)) + "\" r=\"" + (isFront ? "6" : "4.5") +
                          "\"><title>" + escapedHtml(tooltip(results_, all_[s], s)) +
                          "</title></circle>\n";
        if (isFront)
            svg += textSvg(x(s) + 9.0, y(s) - 7.0, std::to_string(s + 1), "font-weight=\"bold\"");
        return svg;
    }

    const SweepResults& results_;
    const std::vector<SettingSummary>& all_;
    std::vector<std::size_t> front_;
    Scale x_;
    Scale y_;
};
}  // namespace

std::string paretoSvg(const SweepResults& results)
{
    const std::vector<SettingSummary> all = summaries(results);
    std::vector<double> times;
    std::vector<double> scores;
    for (const SettingSummary& summary : all)
    {
        const std::optional<double> score = summary.means[goalIndex(results)];
        if (!score || !summary.msPerFrame) continue;
        times.push_back(*summary.msPerFrame);
        scores.push_back(*score);
    }
    if (times.empty()) return "";
    return "<svg viewBox=\"0 0 " + toFixedText(kWidth, 0) + " " + toFixedText(kHeight, 0) +
           "\" width=\"" + toFixedText(kWidth, 0) + "\" role=\"img\">\n" +
           ParetoDrawing(results, all, times, scores).svg() + "</svg>\n";
}

}  // namespace vdamf

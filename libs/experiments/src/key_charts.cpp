// SPDX-License-Identifier: BSD-3-Clause
#include "key_charts.h"

#include <algorithm>
#include <utility>

#include "key_axis.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kMostNamed = 6;

struct Mean
{
    double sum = 0.0;
    int count = 0;

    void add(double value)
    {
        sum += value;
        ++count;
    }
    double value() const { return sum / count; }
};

bool isKnown(const SweepRow& row, std::size_t metric)
{
    return row.failure.empty() && row.values[metric].has_value();
}

std::string nameOf(const SweepResults& results, std::size_t recording)
{
    const std::size_t count = results.recordings.size();
    return count > 1 && count <= kMostNamed ? results.recordings[recording] : "";
}

// By recording, then by the key's value.
std::vector<std::vector<Mean>> meansOf(const SweepResults& results, std::size_t metric,
                                       const KeyAxis& axis)
{
    std::vector<std::vector<Mean>> means(results.recordings.size(),
                                         std::vector<Mean>(axis.values.size()));
    for (const SweepRow& row : results.rows)
        if (isKnown(row, metric))
            means[row.recording][axis.ofSetting[row.setting]].add(*row.values[metric]);
    return means;
}

void addMeans(const SweepResults& results, std::size_t metric, const KeyAxis& axis, Chart& chart)
{
    const auto means = meansOf(results, metric, axis);
    // There is nothing between words that a line could pass through.
    const CurveStyle style = axis.areWords ? CurveStyle::Points : CurveStyle::Line;
    Curve middle{means.size() > 1 ? "mean" : "", style, {}};
    for (std::size_t v = 0; v < axis.values.size(); ++v)
    {
        Mean mean;
        for (const auto& recording : means)
            if (recording[v].count > 0) mean.add(recording[v].value());
        if (mean.count > 0) middle.points.emplace_back(axis.places[v], mean.value());
    }
    chart.curves.push_back(std::move(middle));
    for (std::size_t r = 0; r < means.size(); ++r)
    {
        Curve points{nameOf(results, r), CurveStyle::Points, {}};
        for (std::size_t v = 0; v < axis.values.size(); ++v)
            if (means[r][v].count > 0)
                points.points.emplace_back(axis.places[v], means[r][v].value());
        chart.curves.push_back(std::move(points));
    }
}

void addRuns(const SweepResults& results, std::size_t metric, const KeyAxis& axis, Chart& chart)
{
    for (std::size_t r = 0; r < results.recordings.size(); ++r)
        chart.curves.push_back({nameOf(results, r), CurveStyle::Points, {}});
    for (const SweepRow& row : results.rows)
        if (isKnown(row, metric))
            chart.curves[row.recording].points.emplace_back(
                axis.places[axis.ofSetting[row.setting]], *row.values[metric]);
}
// Of all points, in one coordinate.
std::pair<double, double> extent(const Chart& chart, Eigen::Index coordinate)
{
    std::pair<double, double> ends(0.0, 0.0);
    bool isFirst = true;
    for (const Curve& curve : chart.curves)
    {
        for (const Eigen::Vector2d& point : curve.points)
        {
            const double value = point[coordinate];
            ends.first = isFirst ? value : std::min(ends.first, value);
            ends.second = isFirst ? value : std::max(ends.second, value);
            isFirst = false;
        }
    }
    return ends;
}

// So that no point lies on the border, or below the legend in the upper right corner.
void makeRoom(Chart& chart)
{
    constexpr double kMargin = 0.05;
    constexpr double kLegendLine = 0.075;  // of the chart's height
    const auto [left, right] = extent(chart, 0);
    const auto [low, high] = extent(chart, 1);
    if (chart.x.scale == AxisScale::Linear && chart.x.min == chart.x.max && right > left)
    {
        chart.x.min = left - kMargin * (right - left);
        chart.x.max = right + kMargin * (right - left);
    }
    const auto named = std::count_if(chart.curves.begin(), chart.curves.end(),
                                     [](const Curve& curve) { return !curve.name.empty(); });
    if (high <= low) return;
    const double room = 2.0 * kMargin + kLegendLine * static_cast<double>(named);
    chart.y.min = low - kMargin * (high - low);
    chart.y.max = low + (high - low) / (1.0 - room);
}
}  // namespace

Chart keyChart(const SweepResults& results, std::size_t metric, std::size_t key)
{
    const KeyAxis axis = keyAxis(results, key);
    Chart chart;
    chart.title = results.metrics[metric];
    chart.x = axis.axis;
    const bool isScattered =
        results.keys.size() > 1 && axis.values.size() == results.settings.size();
    if (isScattered)
        addRuns(results, metric, axis, chart);
    else
        addMeans(results, metric, axis, chart);
    makeRoom(chart);
    return chart;
}

}  // namespace vdamf

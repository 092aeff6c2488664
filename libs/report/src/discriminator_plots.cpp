// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/discriminator_plots.h"

namespace vdamf
{
namespace
{
constexpr double kLeast = 1e-4;

/// A curve and its band in one colour; `y` of a true positive rate.
template <class Y>
void append(Chart& chart, const NamedRoc& named, std::size_t colour, Y y)
{
    Curve curve = {named.name, CurveStyle::Line, {}, colour};
    for (const RocPoint& p : named.roc.curve)
        curve.points.emplace_back(p.falsePositiveRate, y(p.truePositiveRate));
    // One line for both sides of the band: there along the low one, back along the high one.
    Curve band = {
        named.roc.band.empty() ? "" : named.name + ", 95 %", CurveStyle::Dashed, {}, colour};
    for (const RocBandPoint& p : named.roc.band)
        band.points.emplace_back(p.falsePositiveRate, y(p.low));
    for (auto p = named.roc.band.rbegin(); p != named.roc.band.rend(); ++p)
        band.points.emplace_back(p->falsePositiveRate, y(p->high));
    chart.curves.push_back(curve);
    chart.curves.push_back(band);
}
}  // namespace

Chart rocChart(const std::vector<NamedRoc>& curves)
{
    Chart chart = {"ROC of the discriminator, held-out tracks",
                   {"false positive rate", AxisScale::Log10, kLeast, 1.0},
                   {"true positive rate", AxisScale::Linear, 0.5, 1.0},
                   {},
                   true};
    for (std::size_t i = 0; i < curves.size(); ++i)
        append(chart, curves[i], i, [](double found) { return found; });
    return chart;
}

Chart detChart(const std::vector<NamedRoc>& curves)
{
    Chart chart = {"DET of the discriminator, held-out tracks",
                   {"false positive rate, %", AxisScale::NormalDeviate, 1e-3, 0.6},
                   {"miss rate, %", AxisScale::NormalDeviate, 1e-3, 0.6},
                   {}};
    for (std::size_t i = 0; i < curves.size(); ++i)
        append(chart, curves[i], i, [](double found) { return 1.0 - found; });
    chart.curves.push_back({"equal errors", CurveStyle::Dashed, {{1e-3, 1e-3}, {0.6, 0.6}}});
    return chart;
}

Chart reliabilityChart(const std::vector<NamedReliability>& curves)
{
    Chart chart = {"Reliability of vehicle_probability, held-out tracks",
                   {"probability told", AxisScale::Linear, 0.0, 1.0},
                   {"share of vehicles", AxisScale::Linear, 0.0, 1.0},
                   {},
                   true};
    for (const NamedReliability& named : curves)
    {
        Curve curve = {named.name, CurveStyle::Line, {}};
        for (const ReliabilityBin& bin : named.reliability.bins)
            curve.points.emplace_back(bin.probability, bin.share);
        chart.curves.push_back(curve);
    }
    chart.curves.push_back({"expected", CurveStyle::Dashed, {{0.0, 0.0}, {1.0, 1.0}}});
    return chart;
}

}  // namespace vdamf

// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/evaluation_plots.h"

#include <algorithm>
#include <limits>

#include "degrees.h"
#include "vdamf/evaluation/chi_square.h"
#include "vdamf/evaluation/statistics.h"

namespace vdamf
{
namespace
{
const Axis kShareOfPairs = {"share of pairs", AxisScale::Linear, 0.0, 1.0};

template <class Member>
Curve cumulative(const char* name, const std::vector<PoseError>& pairs, Member member,
                 double unit = 1.0)
{
    std::vector<double> values;
    for (const PoseError& pair : pairs)
    {
        const std::optional<double> value = pair.*member;
        if (value) values.push_back(unit * *value);
    }
    return cumulativeCurve(name, std::move(values));
}

/// The axis ends where 95 % of all curves are: the tail would press the rest against the left.
Chart cumulativeChart(const char* title, const char* label, std::vector<Curve> curves)
{
    double end = 0.0;
    for (const Curve& curve : curves)
    {
        if (curve.points.empty()) continue;
        const auto last = static_cast<double>(curve.points.size() - 1);
        end = std::max(end, curve.points[static_cast<std::size_t>(0.95 * last)].x());
    }
    const Axis x = {label, AxisScale::Linear, 0.0, end};
    return {title, x, kShareOfPairs, std::move(curves), true};
}

Chart rangeChart(const std::vector<ErrorGroup>& groups)
{
    // Middles of the groups of byRange(), the last one is open.
    constexpr double kMiddles[] = {5.0, 15.0, 30.0, 50.0, 70.0};
    Curve position = {"position, m", CurveStyle::Line, {}};
    Curve corner = {"nearest corner, m", CurveStyle::Line, {}};
    Curve length = {"length, m", CurveStyle::Line, {}};
    for (std::size_t i = 0; i < std::min(groups.size(), std::size(kMiddles)); ++i)
    {
        const ErrorSummary& errors = groups[i].errors;
        if (errors.pairs == 0) continue;
        position.points.emplace_back(kMiddles[i], errors.position.median);
        corner.points.emplace_back(kMiddles[i], errors.corner.median);
        length.points.emplace_back(kMiddles[i], errors.length.median);
    }
    const Axis x = {"range, m", AxisScale::Linear, 0.0, 80.0};
    return {"Median errors by range", x, {"m", AxisScale::Linear}, {position, corner, length}};
}

/// Share of the values that lie within each probability of the chi-square distribution.
Curve coverageCurve(const char* name, std::vector<double> values, int dimension)
{
    Curve curve = {name, CurveStyle::Line, {}};
    if (values.empty()) return curve;
    for (double& value : values)
    {
        if (!(value >= 0.0)) value = std::numeric_limits<double>::infinity();
    }
    std::sort(values.begin(), values.end());
    const auto count = static_cast<double>(values.size());
    for (int percent = 0; percent < 100; percent += 2)
    {
        const double p = 0.01 * percent;
        const double point = percent == 0 ? 0.0 : chiSquareQuantile(p, dimension);
        const auto above = std::upper_bound(values.begin(), values.end(), point);
        curve.points.emplace_back(p, static_cast<double>(above - values.begin()) / count);
    }
    return curve;
}

std::vector<double> nisOf(const std::vector<PoseError>& pairs)
{
    std::vector<double> values;
    for (const PoseError& pair : pairs)
    {
        if (pair.nis) values.push_back(*pair.nis);
    }
    return values;
}

std::vector<double> neesOf(const std::vector<PoseError>& pairs, double PoseError::*nees)
{
    std::vector<double> values;
    for (const PoseError& pair : pairs)
    {
        if (pair.status == TrackStatus::Confirmed) values.push_back(pair.*nees);
    }
    return values;
}

Chart consistencyChart(const std::vector<PoseError>& pairs)
{
    return {"Consistency: errors within the covariance's ellipses",
            {"expected share", AxisScale::Linear, 0.0, 1.0},
            {"share", AxisScale::Linear, 0.0, 1.0},
            {coverageCurve("NEES of pose", neesOf(pairs, &PoseError::neesPose), 3),
             coverageCurve("NEES of speed", neesOf(pairs, &PoseError::neesSpeed), 1),
             coverageCurve("NEES of size", neesOf(pairs, &PoseError::neesSize), 2),
             coverageCurve("NIS", nisOf(pairs), 3),
             {"expected", CurveStyle::Dashed, {{0.0, 0.0}, {1.0, 1.0}}}},
            true};
}

Chart hotaChart(const Hota& hota)
{
    Curve all = {"HOTA", CurveStyle::Line, {}};
    Curve detection = {"DetA", CurveStyle::Line, {}};
    Curve association = {"AssA", CurveStyle::Line, {}};
    for (const HotaAtAlpha& at : hota.atAlpha)
    {
        all.points.emplace_back(at.alpha, at.hota);
        detection.points.emplace_back(at.alpha, at.detA);
        association.points.emplace_back(at.alpha, at.assA);
    }
    return {"HOTA by overlap",
            {"overlap from which a pair counts", AxisScale::Linear, 0.0, 1.0},
            {"score", AxisScale::Linear, 0.0, 1.0},
            {all, detection, association}};
}

Chart rocChart(const Roc& roc)
{
    Curve curve = {"", CurveStyle::Line, {}};
    for (const RocPoint& p : roc.curve)
        curve.points.emplace_back(p.falsePositiveRate, p.truePositiveRate);
    return {"ROC of the discriminator",
            {"false positive rate", AxisScale::Linear, 0.0, 1.0},
            {"true positive rate", AxisScale::Linear, 0.0, 1.0},
            {curve, {"chance", CurveStyle::Dashed, {{0.0, 0.0}, {1.0, 1.0}}}},
            true};
}

Chart detChart(const Roc& roc)
{
    Curve curve = {"", CurveStyle::Line, {}};
    for (const RocPoint& p : roc.curve)
        curve.points.emplace_back(p.falsePositiveRate, 1.0 - p.truePositiveRate);
    return {"DET of the discriminator",
            {"false positive rate, %", AxisScale::NormalDeviate, 1e-3, 0.6},
            {"miss rate, %", AxisScale::NormalDeviate, 1e-3, 0.6},
            {curve, {"equal errors", CurveStyle::Dashed, {{1e-3, 1e-3}, {0.6, 0.6}}}}};
}
}  // namespace

const std::vector<std::string>& evaluationChartNames()
{
    static const std::vector<std::string> kNames = {
        "position", "heading", "speed", "size", "range", "consistency", "hota", "roc", "det"};
    return kNames;
}

std::vector<NamedChart> evaluationCharts(const Evaluation& e)
{
    const std::vector<PoseError>& pairs = e.pairs;
    std::vector<NamedChart> charts = {
        {"position", cumulativeChart("Position", "m",
                                     {cumulative("centre", pairs, &PoseError::position),
                                      cumulative("longitudinal", pairs, &PoseError::longitudinal),
                                      cumulative("lateral", pairs, &PoseError::lateral),
                                      cumulative("nearest corner", pairs, &PoseError::corner)})},
        {"heading",
         cumulativeChart("Heading", "deg",
                         {cumulative("mod 180", pairs, &PoseError::headingAxis, kDegrees)})},
        {"speed", cumulativeChart("Speed", "m/s", {cumulative("speed", pairs, &PoseError::speed)})},
        {"size", cumulativeChart("Size", "m",
                                 {cumulative("length", pairs, &PoseError::length),
                                  cumulative("width", pairs, &PoseError::width)})},
        {"range", rangeChart(e.errorsByRange)},
        {"consistency", consistencyChart(pairs)},
        {"hota", hotaChart(e.hota)}};
    if (e.roc)
    {
        charts.push_back({"roc", rocChart(*e.roc)});
        charts.push_back({"det", detChart(*e.roc)});
    }
    return charts;
}

}  // namespace vdamf

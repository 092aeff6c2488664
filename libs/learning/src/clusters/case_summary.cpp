// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/clusters/case_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "vdamf/evaluation/chi_square.h"

namespace vdamf
{
namespace
{
// The values that are there, of a member of all cases.
template <class Member>
std::vector<double> valuesOf(const std::vector<CaseErrors>& cases, Member CaseErrors::*member)
{
    std::vector<double> values;
    for (const CaseErrors& one : cases)
    {
        const std::optional<double> value = one.*member;
        if (value) values.push_back(*value);
    }
    return values;
}

double share(std::size_t part, std::size_t whole)
{
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole)
                     : std::numeric_limits<double>::quiet_NaN();
}

void setConsistency(CaseSummary& summary, const std::vector<CaseErrors>& cases)
{
    double sum = 0.0;
    double freedom = 0.0;
    std::size_t inside[3] = {0, 0, 0};
    const double levels[3] = {0.68, 0.95, 0.99};
    std::vector<double> scales;  // squared error over its expected median
    for (const CaseErrors& one : cases)
    {
        if (!one.nees) continue;
        const double dimension = one.neesDimension;
        sum += *one.nees;
        freedom += dimension;
        scales.push_back(*one.nees / chiSquareQuantile(0.5, dimension));
        for (int k = 0; k < 3; ++k)
            if (*one.nees <= chiSquareQuantile(levels[k], dimension)) ++inside[k];
    }
    summary.neesCount = scales.size();
    summary.within68 = share(inside[0], scales.size());
    summary.within95 = share(inside[1], scales.size());
    summary.within99 = share(inside[2], scales.size());
    summary.neesScale = quantile(scales, 0.5);
    const bool any = freedom > 0.0;
    const double none = std::numeric_limits<double>::quiet_NaN();
    summary.neesMean = any ? sum / freedom : none;
    summary.neesLow = any ? chiSquareQuantile(0.025, freedom) / freedom : none;
    summary.neesHigh = any ? chiSquareQuantile(0.975, freedom) / freedom : none;
}
}  // namespace

double quantile(std::vector<double> values, double share)
{
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double part = place - static_cast<double>(below);
    return values[below] + part * (values[above] - values[below]);
}

ErrorFigures figuresOf(const std::vector<double>& errors)
{
    std::vector<double> sizes = errors;
    for (double& size : sizes) size = std::abs(size);
    return {quantile(errors, 0.5), quantile(sizes, 0.5), quantile(sizes, 0.9), errors.size()};
}

CaseSummary summaryOf(const std::vector<CaseErrors>& cases)
{
    CaseSummary s;
    s.cases = cases.size();
    s.heading90 = figuresOf(valuesOf(cases, &CaseErrors::heading90));
    s.heading180 = figuresOf(valuesOf(cases, &CaseErrors::heading180));
    s.corner = figuresOf(valuesOf(cases, &CaseErrors::corner));
    s.end = figuresOf(valuesOf(cases, &CaseErrors::end));
    s.side = figuresOf(valuesOf(cases, &CaseErrors::side));
    s.length = figuresOf(valuesOf(cases, &CaseErrors::length));
    s.width = figuresOf(valuesOf(cases, &CaseErrors::width));
    const std::vector<double> iou = valuesOf(cases, &CaseErrors::iou);
    s.iouMedian = quantile(iou, 0.5);
    s.iouP10 = quantile(iou, 0.1);
    std::vector<double> iterations;
    std::size_t crossed = 0;
    std::size_t failed = 0;
    for (const CaseErrors& one : cases)
    {
        iterations.push_back(one.iterations);
        if (one.heading180 > 45.0) ++crossed;
        if (one.failed) ++failed;
    }
    s.iterations = quantile(iterations, 0.5);
    s.crossed = share(crossed, cases.size());
    s.failed = share(failed, cases.size());
    setConsistency(s, cases);
    return s;
}

}  // namespace vdamf

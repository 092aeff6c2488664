// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/consistency.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "vdamf/evaluation/chi_square.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kFewest = 30;
constexpr double kTolerance = 0.2;  // of the variance: less does not matter to anybody

// A squared error below zero comes from a covariance that is none.
double madeSortable(double value)
{
    return std::isfinite(value) && value >= 0.0 ? value : std::numeric_limits<double>::infinity();
}

double meanOfFinite(const std::vector<double>& sorted)
{
    double sum = 0.0;
    std::size_t count = 0;
    for (const double value : sorted)
    {
        if (!std::isfinite(value)) break;
        sum += value;
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::infinity();
}

double medianOf(const std::vector<double>& sorted)
{
    const std::size_t half = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

double shareBelow(const std::vector<double>& sorted, double probability, int dimension)
{
    const double point = chiSquareQuantile(probability, dimension);
    const auto above = std::upper_bound(sorted.begin(), sorted.end(), point);
    return static_cast<double>(above - sorted.begin()) / static_cast<double>(sorted.size());
}

/// More values above the 99 % point than chance (3 sigma) and a slightly wrong covariance explain.
bool hasOutliers(const Consistency& c)
{
    const double chance = 0.01 + 3.0 * std::sqrt(0.01 * 0.99 / static_cast<double>(c.count));
    return 1.0 - c.within99 > std::max(0.03, chance);
}

std::string tailInWords(const Consistency& c)
{
    return toFixedText(100.0 * (1.0 - c.within99), 1) +
           " % of the values lie above the 99 % point (expected 1 %)";
}

std::string sizeInWords(const Consistency& c)
{
    if (!std::isfinite(c.covarianceScale))
        return "half of the errors or more have no covariance (a variance of 0)";
    return "errors are " + toFixedText(std::sqrt(c.covarianceScale), 2) +
           " times as large as the filter says";
}
}  // namespace

Consistency consistencyOf(const std::vector<double>& values, int dimension)
{
    assert(dimension > 0);
    Consistency result;
    result.count = values.size();
    result.dimension = dimension;
    if (values.empty()) return result;
    std::vector<double> sorted;
    sorted.reserve(values.size());
    for (const double value : values) sorted.push_back(madeSortable(value));
    std::sort(sorted.begin(), sorted.end());
    const double freedom = static_cast<double>(dimension) * static_cast<double>(values.size());
    result.mean = meanOfFinite(sorted) / dimension;
    result.lowerBound = chiSquareQuantile(0.025, freedom) / freedom;
    result.upperBound = chiSquareQuantile(0.975, freedom) / freedom;
    result.median = medianOf(sorted);
    result.within68 = shareBelow(sorted, 0.68, dimension);
    result.within95 = shareBelow(sorted, 0.95, dimension);
    result.within99 = shareBelow(sorted, 0.99, dimension);
    result.covarianceScale = result.median / chiSquareQuantile(0.5, dimension);
    return result;
}

Verdict verdictOf(const Consistency& c)
{
    if (c.count < kFewest) return Verdict::TooFew;
    const bool medianIsLarge = c.covarianceScale > 1.0 + kTolerance;
    if (hasOutliers(c) && !medianIsLarge) return Verdict::HeavyTailed;
    const bool inBand = c.mean >= c.lowerBound && c.mean <= c.upperBound;
    const bool near = std::abs(c.mean - 1.0) <= kTolerance;
    // Values that are not finite are not in the mean, but are outliers.
    if ((inBand || near) && !hasOutliers(c)) return Verdict::Consistent;
    if (c.mean < 1.0 && !hasOutliers(c)) return Verdict::Underconfident;
    return medianIsLarge ? Verdict::Overconfident : Verdict::HeavyTailed;
}

std::string inWords(const Consistency& c)
{
    switch (verdictOf(c))
    {
        case Verdict::TooFew:
            return "too few values to tell (" + std::to_string(c.count) + ", 30 are needed)";
        case Verdict::Consistent:
            return "consistent: errors are as large as the filter says; " + tailInWords(c);
        case Verdict::Overconfident:
            return "overconfident: " + sizeInWords(c) + "; " + tailInWords(c);
        case Verdict::Underconfident:
            return "underconfident: " + sizeInWords(c) + "; " + tailInWords(c);
        case Verdict::HeavyTailed:
            return "heavy-tailed: most " + sizeInWords(c) + ", but " + tailInWords(c);
    }
    return "";
}

}  // namespace vdamf

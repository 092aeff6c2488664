// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/statistics.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
double quantileOf(const std::vector<double>& sorted, double fraction)
{
    if (sorted.empty()) return 0.0;
    const double at = fraction * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

ErrorStatistics statisticsOf(const std::vector<double>& errors)
{
    ErrorStatistics result;
    if (errors.empty()) return result;
    std::vector<double> sizes;
    sizes.reserve(errors.size());
    double sum = 0.0;
    double squares = 0.0;
    for (const double error : errors)
    {
        sizes.push_back(std::abs(error));
        sum += error;
        squares += error * error;
    }
    std::sort(sizes.begin(), sizes.end());
    const auto count = static_cast<double>(errors.size());
    result.count = errors.size();
    result.median = quantileOf(sizes, 0.5);
    result.p90 = quantileOf(sizes, 0.9);
    result.p95 = quantileOf(sizes, 0.95);
    result.max = sizes.back();
    result.rms = std::sqrt(squares / count);
    result.bias = sum / count;
    return result;
}

}  // namespace vdamf

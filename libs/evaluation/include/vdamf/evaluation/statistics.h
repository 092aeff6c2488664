// SPDX-License-Identifier: BSD-3-Clause
// A set of errors in a few numbers.
#pragma once

#include <cstddef>
#include <vector>

namespace vdamf
{
/// Of errors with a sign: `bias` keeps it, `median`, `p90` and `p95` are of the sizes.
struct ErrorStatistics
{
    std::size_t count = 0;
    double median = 0.0;
    double p90 = 0.0;
    double p95 = 0.0;
    double max = 0.0;
    double rms = 0.0;
    double bias = 0.0;  ///< mean
};

/// All zero where there is no error. Values must be finite.
ErrorStatistics statisticsOf(const std::vector<double>& errors);

/// The value below which the share `fraction` (0..1) lies, linear between neighbours, 0 where
/// nothing is given. `sorted` by rising value.
double quantileOf(const std::vector<double>& sorted, double fraction);

}  // namespace vdamf

// SPDX-License-Identifier: BSD-3-Clause
// The first and the last time of the points of a scan.
#pragma once

#include <limits>
#include <vector>

namespace vdamf
{
/// s; without any time the first one is after the last one.
struct TimeRange
{
    float first = std::numeric_limits<float>::infinity();
    float last = -std::numeric_limits<float>::infinity();
};

/// Of those that are finite.
TimeRange timeRangeOf(const std::vector<float>& times);

}  // namespace vdamf

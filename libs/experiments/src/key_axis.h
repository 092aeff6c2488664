// SPDX-License-Identifier: BSD-3-Clause
// The values that a swept key takes in a sweep, in the order of an axis.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vdamf/experiments/results.h"
#include "vdamf/report/plots.h"

namespace vdamf
{
struct KeyAxis
{
    std::vector<std::string> values;     ///< different ones, rising, or in the order of the plan
    std::vector<double> places;          ///< of these: the numbers, or 1, 2, 3 for words
    std::vector<std::size_t> ofSetting;  ///< index in `values` by setting
    Axis axis;
    bool areWords = false;
};

KeyAxis keyAxis(const SweepResults& results, std::size_t key);

}  // namespace vdamf

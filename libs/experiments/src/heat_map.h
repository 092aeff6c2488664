// SPDX-License-Identifier: BSD-3-Clause
// A metric over the values of two swept keys.
#pragma once

#include <cstddef>
#include <string>

#include "vdamf/experiments/results.h"

namespace vdamf
{
/// As SVG for a page with the style of sweepPage(): each field is the mean over the recordings and
/// over the settings that have these two values. Empty where a key has too many values for fields,
/// or the fields are no grid.
std::string heatMapSvg(const SweepResults& results, std::size_t metric, std::size_t across,
                       std::size_t up);

}  // namespace vdamf

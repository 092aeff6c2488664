// SPDX-License-Identifier: BSD-3-Clause
// What can be known of positions beside what the tracker tells.
#pragma once

#include <string>
#include <vector>

#include "regression/metric.h"

namespace vdamf
{
/// Rows of runs `<scenario>/<run>`, in one order, that have the RMS of positions alone.
struct FloorRows
{
    std::vector<RegressionRow> online;
    std::vector<RegressionRow> alike;  ///< of who takes trucks and buses for the same
    std::vector<RegressionRow> hindsight;
};

/// For a terminal: of each scenario and of all runs the RMS over runs, in hindsight, online, and of
/// who takes trucks and buses for the same, and in how many runs these are above `limit` (m); then
/// the same of the tracker where `tracked`, a table of any runs, has them all ("-": it has not).
/// Empty: no such columns.
std::string floorTable(const FloorRows& floor, const std::vector<RegressionRow>& tracked,
                       double limit);

}  // namespace vdamf

// SPDX-License-Identifier: BSD-3-Clause
// The errors as a picture: a row a condition, a dot a method.
#pragma once

#include <string>
#include <vector>

#include "vdamf/learning/clusters/case_summary.h"

namespace vdamf
{
/// SVG with the median heading error on the left and the median corner error on the right, on
/// logarithmic axes; lines reach to the 90th percentiles. At most eight methods are told apart.
std::string dotPlot(const std::vector<CaseSummary>& rows);

}  // namespace vdamf

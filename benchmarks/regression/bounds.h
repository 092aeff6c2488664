// SPDX-License-Identifier: BSD-3-Clause
// What the numbers of a scenario must not leave.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "regression/metric.h"

namespace vdamf
{
struct Bound
{
    std::string scenario;
    std::size_t metric = 0;  ///< in metrics()
    std::optional<double> min;
    std::optional<double> max;
};

/// Reads a table `scenario,metric,min,max`; an empty cell: no bound on this side. Throws
/// std::runtime_error that names file, line and column: unknown metric, no bound at all, min above
/// max, the same scenario and metric twice.
std::vector<Bound> readBounds(const std::filesystem::path& path);

/// A sentence for each bound that a row leaves or has no value for. Bounds of scenarios that are
/// not among the rows do not count.
std::vector<std::string> violations(const std::vector<Bound>& bounds,
                                    const std::vector<RegressionRow>& rows);

}  // namespace vdamf

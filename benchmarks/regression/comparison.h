// SPDX-License-Identifier: BSD-3-Clause
// What changed between two regression tables, and whether for the better.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "regression/metric.h"

namespace vdamf
{
enum class Trend
{
    Better,
    Worse,
    Changed  ///< neither: the metric has no better way, or a value came or went
};

struct Change
{
    std::string scenario;
    std::size_t metric = 0;  ///< in metrics()
    std::optional<double> before;
    std::optional<double> after;
    Trend trend = Trend::Changed;
};

struct Comparison
{
    std::vector<Change> changes;         ///< by scenario of the new table, then by metric
    std::vector<std::string> unchanged;  ///< scenarios
    std::vector<std::string> onlyBefore;
    std::vector<std::string> onlyAfter;
};

/// Changes that the printed table would show and that are larger than the metric's noise.
Comparison compared(const std::vector<RegressionRow>& before,
                    const std::vector<RegressionRow>& after);

/// For a terminal: changes by scenario, then how often each metric became better and worse.
std::string inWords(const Comparison& comparison);

}  // namespace vdamf

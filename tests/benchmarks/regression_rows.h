// SPDX-License-Identifier: BSD-3-Clause
// Rows of the regression table for tests.
#pragma once

#include <string>

#include "regression/metric.h"

namespace vdamf
{
/// A row with the same value in every column.
inline RegressionRow regressionRow(const std::string& scenario, double value)
{
    return {scenario, MetricValues(metrics().size(), value)};
}

}  // namespace vdamf

// SPDX-License-Identifier: BSD-3-Clause
// Runs of one scenario, taken together.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "regression/metric.h"

namespace vdamf
{
/// A metric by name, as a table heads it.
struct TitledMetric
{
    const char* title;
    const char* metric;
};

/// A scenario and its rows.
using RegressionGroup = std::pair<std::string, std::vector<RegressionRow>>;

/// Rows `<scenario>/<run>` by scenario, as they follow each other.
std::vector<RegressionGroup> byScenario(const std::vector<RegressionRow>& rows);

/// The row of that scenario; nothing where there is none.
const RegressionRow* findRow(const std::vector<RegressionRow>& rows, const std::string& scenario);

/// Values of a metric by name, where they are known.
std::vector<double> knownValues(const std::vector<RegressionRow>& rows, const char* metric);

/// Of at least one value.
double meanOf(const std::vector<double>& values);
double rmsOf(const std::vector<double>& values);

/// A number as printf shows it.
std::string cell(const char* format, double value);

}  // namespace vdamf

// SPDX-License-Identifier: BSD-3-Clause
// The regression table for a terminal, as Markdown and as CSV.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "regression/metric.h"

namespace vdamf
{
/// One line a scenario, and the median of each column below; at most 130 characters wide.
std::string terminalTable(const std::vector<RegressionRow>& rows);

/// The same as a Markdown table.
std::string markdownTable(const std::vector<RegressionRow>& rows);

/// What the short headings mean.
std::string tableLegend();

/// `scenario` and all metrics by their names, in their units; an empty cell: not known.
std::string toCsv(const std::vector<RegressionRow>& rows);

/// Reads toCsv()'s tables; metrics that an older table does not have are not known. Throws
/// std::runtime_error that names file, line and column.
std::vector<RegressionRow> readRegressionTable(const std::filesystem::path& path);

}  // namespace vdamf

// SPDX-License-Identifier: BSD-3-Clause
// The results as text: for the terminal, as CSV, as Markdown.
#pragma once

#include <string>
#include <vector>

#include "measurement/timing.h"
#include "vdamf/learning/clusters/case_summary.h"
#include "vdamf/learning/clusters/labelled_cluster.h"

namespace vdamf
{
/// One condition: a headline, a line of headings, a line a method.
std::string terminalBlock(const LabelledClusters& condition, const std::vector<CaseSummary>& rows);

/// What the short headings of the tables mean.
std::string legend();

std::string toCsv(const std::vector<CaseSummary>& rows);

std::string terminalTiming(const Timing& timing);
std::string timingCsv(const Timing& timing);

/// All tables as one Markdown page.
std::string markdownPage(const std::vector<CaseSummary>& rows, const Timing& timing);

}  // namespace vdamf
